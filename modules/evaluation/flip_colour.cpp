#include "evaluation/flip_colour.h"

#include <algorithm>
#include <cmath>

namespace lampyris::evaluation {
namespace {

using Matrix = std::array<Colour, 3>;

// [eq] Linear sRGB to XYZ and back: the primaries of IEC 61966-2-1, and as white, the sum of each
// row, D65 at x = 0.31271, y = 0.32902.
constexpr Matrix kToXyz{{{0.4123865632530, 0.3575914909206, 0.1804504912036},
                         {0.2126368216773, 0.7151829818413, 0.0721801964814},
                         {0.0193306201525, 0.1191971636402, 0.9503725870054}}};
constexpr Matrix kFromXyz{{{3.2410032329764, -1.5373989694888, -0.4986158819964},
                           {-0.9692242522025, 1.8759299836952, 0.0415542263401},
                           {0.0556394198520, -0.2040112061239, 1.0571489771875}}};
constexpr Colour kWhite{0.9504285453772, 1.0, 1.0889003707981};

Colour multiply(const Matrix& m, const Colour& v) {
    Colour result{};
    for (size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

/// XYZ as shares of white.
Colour xyzOf(const Colour& linearRgb) {
    Colour xyz = multiply(kToXyz, linearRgb);
    for (size_t i = 0; i < 3; ++i) xyz[i] /= kWhite[i];
    return xyz;
}

/// The cube root of CIE 15 with its straight piece near 0.
double lightnessOf(double share) {
    constexpr double kDelta = 6.0 / 29.0;
    return share > kDelta * kDelta * kDelta ? std::cbrt(share)
                                            : share / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

}  // namespace

Colour opponentOf(const Colour& linearRgb) {
    const Colour xyz = xyzOf(linearRgb);
    return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

Colour screenColourOf(const Colour& opponent) {
    const double y = (opponent[0] + 16.0) / 116.0;
    Colour rgb = multiply(kFromXyz, {(y + opponent[1] / 500.0) * kWhite[0], y * kWhite[1],
                                     (y - opponent[2] / 200.0) * kWhite[2]});
    for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
    return rgb;
}

Colour huntLabOf(const Colour& linearRgb) {
    const Colour xyz = xyzOf(linearRgb);
    const double x = lightnessOf(xyz[0]);
    const double y = lightnessOf(xyz[1]);
    const double z = lightnessOf(xyz[2]);
    const double lightness = 116.0 * y - 16.0;
    const double hunt = 0.01 * lightness;
    return {lightness, hunt * 500.0 * (x - y), hunt * 200.0 * (y - z)};
}

double hyabDistance(const Colour& a, const Colour& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

}  // namespace lampyris::evaluation
