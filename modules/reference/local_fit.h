/// \file A surface of second degree through noisy values of a neighbourhood, by least squares.
#pragma once

#include <array>

#include "math/glm.h"

namespace lampyris::reference {

/// Fits a + b·u + c·v + d·u² + e·uv + f·v² to values of three channels; (u, v) = (0, 0) is the
/// centre. A plane where there are too few points for that, or too many in a row; else a mean.
class LocalFit {
 public:
    /// `variance` is that of the value's mean channel.
    void add(const glm::dvec2& at, const glm::dvec3& value, double variance);

    /// The fit's value at the centre, and the variance of its mean channel.
    struct Estimate {
        glm::dvec3 value;
        double variance;
    };
    /// There must be a value.
    [[nodiscard]] Estimate atCentre() const;

 private:
    static constexpr size_t kUnknowns = 6;
    using Row = std::array<double, kUnknowns>;

    /// Fits the first `unknowns` alone: how much each sum of weighted values counts at the centre.
    /// False where the points do not tell.
    bool solve(size_t unknowns, Row& weights) const;

    std::array<Row, kUnknowns> products_{};  ///< the lower triangle
    std::array<glm::dvec3, kUnknowns> weighted_{};
    double variance_ = 0.0;
    size_t count_ = 0;
};

}  // namespace lampyris::reference
