#include "scene/builtin/numbers.h"

#include <cmath>

namespace lampyris::scene::builtin {

namespace {

/// Taylor series around 0, for |x| ≤ π/4: the first term left out is under 1e-16.
SinCos sinCosSmall(double x) {
    double sine = 0.0;
    double cosine = 0.0;
    const double square = x * x;
    for (int n = 16; n >= 2; n -= 2) {
        cosine = (1.0 + cosine) * (-square / (n * (n - 1)));
        sine = (1.0 + sine) * (-square / (n * (n + 1)));
    }
    return {x * (1.0 + sine), 1.0 + cosine};
}

}  // namespace

SinCos sinCosTurns(double turns) {
    constexpr double kRadiansPerTurn = 6.283185307179586476925;
    const double quarters = std::floor(4.0 * turns + 0.5);
    const SinCos small = sinCosSmall((turns - 0.25 * quarters) * kRadiansPerTurn);
    switch (static_cast<int64_t>(quarters) & 3) {
        case 0:
            return small;
        case 1:
            return {small.cos, -small.sin};
        case 2:
            return {-small.sin, -small.cos};
        default:
            return {-small.cos, small.sin};
    }
}

}  // namespace lampyris::scene::builtin
