/// \file How many photons a fixed budget allows at a radius: the Thesis' three estimators, fitted
/// by least squares.
#pragma once

#include <array>
#include <span>

namespace lampyris::sandbox::thesis {

struct Affordable {
    double radiusMetres;
    double photons;
};

/// N = c₁/r + c₂/r².
struct Estimator {
    const char* name;
    double c1 = 0.0, c2 = 0.0;
    double rmsPhotons = 0.0;  ///< root of the mean squared difference to what it was fitted to

    [[nodiscard]] double at(double radiusMetres) const {
        return (c1 + c2 / radiusMetres) / radiusMetres;
    }
};

/// N = c/r, N = c/r² and N = c₁/r + c₂/r². All are linear in their constants, so the least squares
/// are exact: where the Thesis' Levenberg–Marquardt ends too. Needs two radii at least.
[[nodiscard]] std::array<Estimator, 3> fitEstimators(std::span<const Affordable> measured);

}  // namespace lampyris::sandbox::thesis
