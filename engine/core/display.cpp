#include "core/display.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace lampyris::core {
namespace {

// Narkowicz's rational fit to the ACES filmic curve [chosen: one line, close to the reference
// curve].
float filmic(float x) {
    return std::clamp((x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

}  // namespace

float encodeSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float decodeSrgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

DisplayImage toDisplay(const Image& image, const DisplayTransform& transform) {
    CHECK(image.channels != 2u);
    CHECK(image.channels <= 4u);
    DisplayImage display{image.width, image.height, {}};
    const size_t pixels = size_t{image.width} * image.height;
    display.values.resize(pixels * 3);
    const float gain = std::exp2(transform.exposureEv);
    for (size_t p = 0; p < pixels; ++p) {
        for (size_t c = 0; c < 3; ++c) {
            const float exposed =
                gain * image.values[p * image.channels + (image.channels == 1 ? 0 : c)];
            const float safe = std::isnan(exposed) ? 0.0f : std::max(exposed, 0.0f);
            const float mapped =
                transform.tonemap == Tonemap::Filmic ? filmic(safe) : std::min(safe, 1.0f);
            display.values[p * 3 + c] =
                static_cast<uint8_t>(std::lround(255.0f * encodeSrgb(mapped)));
        }
    }
    return display;
}

}  // namespace lampyris::core
