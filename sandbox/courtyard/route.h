/// \file A closed way through the courtyard.
#pragma once

#include <span>
#include <vector>

#include "math/glm.h"

namespace lampyris::courtyard {

/// Where one is on a route, and where that leads.
struct Stance {
    glm::vec3 position;
    glm::vec3 forward;  ///< unit, level
};

/// A smooth closed curve through points (Catmull-Rom), walked by its length.
class Route {
 public:
    explicit Route(std::span<const glm::vec3> through);
    /// After so many metres from the first point, any number of rounds either way.
    [[nodiscard]] Stance at(double metres) const;
    [[nodiscard]] double lengthMetres() const { return along_.back(); }

 private:
    std::vector<glm::vec3> points_;  ///< the last is the first again
    std::vector<double> along_;      ///< metres from the first, as many
};

}  // namespace lampyris::courtyard
