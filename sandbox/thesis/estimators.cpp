#include "thesis/estimators.h"

#include <cmath>

#include "core/check.h"

namespace lampyris::sandbox::thesis {
namespace {

/// Sums of the normal equations: with u = 1/r, Σu², Σu³, Σu⁴, ΣuN, Σu²N.
struct Sums {
    double u2 = 0.0, u3 = 0.0, u4 = 0.0, un = 0.0, u2n = 0.0;
};

Sums sumsOf(std::span<const Affordable> measured) {
    Sums s;
    for (const Affordable& m : measured) {
        const double u = 1.0 / m.radiusMetres;
        s.u2 += u * u;
        s.u3 += u * u * u;
        s.u4 += u * u * u * u;
        s.un += u * m.photons;
        s.u2n += u * u * m.photons;
    }
    return s;
}

double rmsOf(const Estimator& estimator, std::span<const Affordable> measured) {
    double squares = 0.0;
    for (const Affordable& m : measured) {
        const double difference = estimator.at(m.radiusMetres) - m.photons;
        squares += difference * difference;
    }
    return std::sqrt(squares / static_cast<double>(measured.size()));
}

}  // namespace

std::array<Estimator, 3> fitEstimators(std::span<const Affordable> measured) {
    const Sums s = sumsOf(measured);
    const double determinant = s.u2 * s.u4 - s.u3 * s.u3;
    CHECK(determinant > 1e-9 * s.u2 * s.u4);  // 0 where there is one radius alone
    std::array<Estimator, 3> all{
        Estimator{"c/r", s.un / s.u2, 0.0}, Estimator{"c/r²", 0.0, s.u2n / s.u4},
        Estimator{"c₁/r + c₂/r²", (s.un * s.u4 - s.u2n * s.u3) / determinant,
                  (s.u2n * s.u2 - s.un * s.u3) / determinant}};
    for (Estimator& estimator : all) estimator.rmsPhotons = rmsOf(estimator, measured);
    return all;
}

}  // namespace lampyris::sandbox::thesis
