#include "reference/local_fit.h"

#include <cmath>

namespace lampyris::reference {
namespace {

constexpr size_t kPointsPerUnknown = 2;  // [chosen]
// Of a term's squares, what those before it leave unexplained. [chosen: less is a row of points]
constexpr double kLeastOwn = 1e-4;

}  // namespace

void LocalFit::add(const glm::dvec2& at, const glm::dvec3& value, double variance) {
    const Row row{1.0, at.x, at.y, at.x * at.x, at.x * at.y, at.y * at.y};
    for (size_t i = 0; i < kUnknowns; ++i) {
        for (size_t j = 0; j <= i; ++j) products_[i][j] += row[i] * row[j];
        weighted_[i] += row[i] * value;
    }
    variance_ += variance;
    ++count_;
}

bool LocalFit::solve(size_t unknowns, Row& weights) const {
    if (unknowns > 1 && count_ < kPointsPerUnknown * unknowns) return false;
    std::array<Row, kUnknowns> lower{};  // Cholesky
    for (size_t i = 0; i < unknowns; ++i)
        for (size_t j = 0; j <= i; ++j) {
            double rest = products_[i][j];
            for (size_t k = 0; k < j; ++k) rest -= lower[i][k] * lower[j][k];
            if (j < i) {
                lower[i][j] = rest / lower[j][j];
            } else {
                if (!(rest > kLeastOwn * products_[i][i])) return false;
                lower[i][i] = std::sqrt(rest);
            }
        }
    // Products · weights = (1, 0, 0, …): the value at the centre is the first unknown.
    for (size_t i = 0; i < unknowns; ++i) {
        double rest = i == 0 ? 1.0 : 0.0;
        for (size_t k = 0; k < i; ++k) rest -= lower[i][k] * weights[k];
        weights[i] = rest / lower[i][i];
    }
    for (size_t i = unknowns; i-- > 0;) {
        for (size_t k = i + 1; k < unknowns; ++k) weights[i] -= lower[k][i] * weights[k];
        weights[i] /= lower[i][i];
    }
    return true;
}

LocalFit::Estimate LocalFit::atCentre() const {
    Row weights{};
    size_t unknowns = kUnknowns;
    while (!solve(unknowns, weights)) unknowns /= 2;  // 6, 3, 1
    glm::dvec3 value(0.0);
    for (size_t i = 0; i < unknowns; ++i) value += weights[i] * weighted_[i];
    return {value, variance_ / static_cast<double>(count_) * weights[0]};
}

}  // namespace lampyris::reference
