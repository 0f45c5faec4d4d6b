/// \file A plane through noisy values of a neighbourhood, by least squares.
#pragma once

#include <array>

#include "math/glm.h"

namespace lampyris::reference {

/// Fits a + b·u + c·v to values of three channels; (u, v) = (0, 0) is the centre.
class PlaneFit {
 public:
    /// `variance` is that of the value's mean channel.
    void add(const glm::dvec2& at, const glm::dvec3& value, double variance);

    /// The plane's value at the centre, and the variance of its mean channel.
    struct Estimate {
        glm::dvec3 value;
        double variance;
    };
    /// The mean where there are too few points, or all in a row.
    [[nodiscard]] Estimate atCentre() const;

 private:
    glm::dmat3 products_{0.0};
    std::array<glm::dvec3, 3> weighted_{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
    double variance_ = 0.0;
    int count_ = 0;
};

}  // namespace lampyris::reference
