#include "reference/plane_fit.h"

namespace lampyris::reference {
namespace {

constexpr int kFewest = 8;             // [chosen: a plane has three unknowns]
constexpr double kLeastSpread = 1e-3;  // of the points across their row, squared [chosen]

}  // namespace

void PlaneFit::add(const glm::dvec2& at, const glm::dvec3& value, double variance) {
    const glm::dvec3 row(1.0, at);
    products_ += glm::outerProduct(row, row);
    for (int c = 0; c < 3; ++c) weighted_[static_cast<size_t>(c)] += value[c] * row;
    variance_ += variance;
    ++count_;
}

PlaneFit::Estimate PlaneFit::atCentre() const {
    const double n = count_;
    const double each = variance_ / n;
    const double spread = glm::determinant(products_) / (n * n * n);
    if (count_ < kFewest || spread < kLeastSpread)
        return {glm::dvec3(weighted_[0].x, weighted_[1].x, weighted_[2].x) / n, each / n};
    const glm::dmat3 inverse = glm::inverse(products_);
    return {{glm::dot(inverse[0], weighted_[0]), glm::dot(inverse[0], weighted_[1]),
             glm::dot(inverse[0], weighted_[2])},
            each * inverse[0].x};
}

}  // namespace lampyris::reference
