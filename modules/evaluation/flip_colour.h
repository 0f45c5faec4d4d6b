/// \file The colour spaces in which FLIP filters and compares.
#pragma once

#include <array>

namespace lampyris::evaluation {

using Colour = std::array<double, 3>;

/// Y Cx Cz, opponent colours linear in light: Y from −16 to 100.
[[nodiscard]] Colour opponentOf(const Colour& linearRgb);
/// Its inverse, clamped to what a screen can show, 0 to 1.
[[nodiscard]] Colour screenColourOf(const Colour& opponent);

/// CIE L*a*b* under D65 with a* and b* scaled by 0.01 L* for the Hunt effect: a colour looks more
/// saturated when it is brighter.
[[nodiscard]] Colour huntLabOf(const Colour& linearRgb);

/// HyAB: the difference in lightness and the distance in chroma, added.
[[nodiscard]] double hyabDistance(const Colour& a, const Colour& b);

}  // namespace lampyris::evaluation
