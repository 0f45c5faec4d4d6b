/// \file From linear radiance to what a screen shows: exposure, tone map, sRGB, 8 bits.
#pragma once

#include <array>
#include <cstddef>

#include "core/image.h"

namespace lampyris::core {

enum class Tonemap { Clip, Filmic };
/// What options and files call them, in their order.
inline constexpr std::array kTonemapNames{"clip", "filmic"};
[[nodiscard]] constexpr const char* name(Tonemap t) {
    return kTonemapNames[static_cast<size_t>(t)];
}

struct DisplayTransform {
    float exposureEv = 0.0f;  ///< radiance is multiplied by 2^EV
    Tonemap tonemap = Tonemap::Clip;
};

/// sRGB opto-electronic transfer function (IEC 61966-2-1), linear in [0, 1] to encoded in [0, 1].
[[nodiscard]] float encodeSrgb(float linear);
/// Its inverse.
[[nodiscard]] float decodeSrgb(float encoded);

/// Display values of an image of 1, 3 or 4 channels (1 is shown grey, the fourth is dropped). NaN
/// shows as 0.
[[nodiscard]] DisplayImage toDisplay(const Image& image, const DisplayTransform& transform);

}  // namespace lampyris::core
