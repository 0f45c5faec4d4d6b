/// \file The picture that travels between rooms: linear floats on the CPU.
#pragma once

#include <cstdint>
#include <vector>

namespace lampyris::core {

/// Linear float image, row by row from the top left, channels interleaved.
struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t channels = 3;
    std::vector<float> values;  ///< width · height · channels

    Image() = default;
    Image(uint32_t imageWidth, uint32_t imageHeight, uint32_t channelCount);

    [[nodiscard]] float& at(uint32_t x, uint32_t y, uint32_t channel);
    [[nodiscard]] float at(uint32_t x, uint32_t y, uint32_t channel) const;
};

/// 8-bit sRGB image as it is shown: three channels interleaved, from the top left.
struct DisplayImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> values;  ///< width · height · 3
};

}  // namespace lampyris::core
