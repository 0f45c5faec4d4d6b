#include "execute/raw_image.h"

#include <cstring>

#include "core/display.h"

namespace lampyris::execute {
namespace {

using graph::Format;

/// Every finite half exactly; NaN stays NaN.
float halfToFloat(uint16_t half) {
    const uint32_t sign = static_cast<uint32_t>(half & 0x8000u) << 16;
    const uint32_t exponent = half >> 10 & 0x1fu;
    const uint32_t mantissa = half & 0x3ffu;
    if (exponent == 0) {
        const float small = static_cast<float>(mantissa) * 0x1p-24f;
        return sign != 0 ? -small : small;
    }
    const uint32_t bits = exponent == 31 ? sign | 0x7f800000u | mantissa << 13
                                         : sign | (exponent + 112) << 23 | mantissa << 13;
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

template <typename T>
T valueAt(const RawImage& raw, size_t index) {
    T value;
    std::memcpy(&value, raw.bytes.data() + index * sizeof(T), sizeof(T));
    return value;
}

float channelAt(const RawImage& raw, size_t index) {
    switch (raw.desc.format) {
        case Format::R32Uint:
        case Format::RGBA32Uint:
            return static_cast<float>(valueAt<uint32_t>(raw, index));
        case Format::RGBA16Float:
            return halfToFloat(valueAt<uint16_t>(raw, index));
        case Format::RGBA8Unorm:
            return static_cast<float>(valueAt<uint8_t>(raw, index)) / 255.0f;
        case Format::BGRA8Unorm: {
            constexpr size_t kSwap[] = {2, 1, 0, 3};
            return static_cast<float>(valueAt<uint8_t>(raw, index / 4 * 4 + kSwap[index % 4])) /
                   255.0f;
        }
        case Format::RGBA8Srgb: {
            const float encoded = static_cast<float>(valueAt<uint8_t>(raw, index)) / 255.0f;
            return index % 4 == 3 ? encoded : core::decodeSrgb(encoded);
        }
        default:
            return valueAt<float>(raw, index);
    }
}

}  // namespace

core::Image toImage(const RawImage& raw) {
    core::Image image{raw.desc.extent.width, raw.desc.extent.height,
                      graph::channels(raw.desc.format)};
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = channelAt(raw, i);
    return image;
}

}  // namespace lampyris::execute
