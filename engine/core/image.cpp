#include "core/image.h"

#include "core/check.h"

namespace lampyris::core {

Image::Image(uint32_t imageWidth, uint32_t imageHeight, uint32_t channelCount)
    : width(imageWidth),
      height(imageHeight),
      channels(channelCount),
      values(size_t{imageWidth} * imageHeight * channelCount, 0.0f) {}

float& Image::at(uint32_t x, uint32_t y, uint32_t channel) {
    CHECK(x < width);
    CHECK(y < height);
    CHECK(channel < channels);
    return values[(size_t{y} * width + x) * channels + channel];
}

float Image::at(uint32_t x, uint32_t y, uint32_t channel) const {
    CHECK(x < width);
    CHECK(y < height);
    CHECK(channel < channels);
    return values[(size_t{y} * width + x) * channels + channel];
}

}  // namespace lampyris::core
