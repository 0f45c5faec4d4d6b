#include "evaluation/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"

namespace lampyris::evaluation {
namespace {

using Colour = std::array<float, 3>;

// [chosen] display values at even steps, each brighter in luma than the one before.
constexpr std::array<Colour, 6> kStops{{{0.0f, 0.0f, 0.0f},
                                        {60.0f, 20.0f, 110.0f},
                                        {150.0f, 35.0f, 120.0f},
                                        {225.0f, 75.0f, 75.0f},
                                        {252.0f, 160.0f, 80.0f},
                                        {255.0f, 250.0f, 190.0f}}};

uint8_t channelAt(float share, size_t channel) {
    const float step = share * static_cast<float>(kStops.size() - 1);
    const size_t below = std::min(static_cast<size_t>(step), kStops.size() - 2);
    const float mix = step - static_cast<float>(below);
    return static_cast<uint8_t>(
        std::lround((1.0f - mix) * kStops[below][channel] + mix * kStops[below + 1][channel]));
}

core::DisplayImage black(uint32_t width, uint32_t height) {
    return {width, height, std::vector<uint8_t>(size_t{width} * height * 3)};
}

/// `image` with its top left corner at (x, y) of `target`.
void paste(const core::DisplayImage& image, uint32_t x, uint32_t y, core::DisplayImage& target) {
    for (size_t row = 0; row < image.height; ++row)
        std::copy_n(image.values.data() + row * image.width * 3, size_t{image.width} * 3,
                    target.values.data() + ((y + row) * target.width + x) * 3);
}

}  // namespace

core::DisplayImage heatMap(const core::Image& values, float brightest) {
    CHECK(values.channels == 1u);
    core::DisplayImage picture = black(values.width, values.height);
    for (size_t i = 0; i < picture.values.size(); ++i) {
        const float share = std::clamp(values.values[i / 3] / brightest, 0.0f, 1.0f);
        picture.values[i] = channelAt(share, i % 3);
    }
    return picture;
}

core::DisplayImage centred(const core::DisplayImage& image, uint32_t width, uint32_t height) {
    CHECK(image.width <= width);
    CHECK(image.height <= height);
    core::DisplayImage picture = black(width, height);
    paste(image, (width - image.width) / 2, (height - image.height) / 2, picture);
    return picture;
}

core::DisplayImage sideBySide(std::span<const core::DisplayImage> images) {
    uint32_t width = 0;
    for (const core::DisplayImage& image : images) width += image.width;
    core::DisplayImage picture = black(width, images.empty() ? 0 : images[0].height);
    uint32_t x = 0;
    for (const core::DisplayImage& image : images) {
        CHECK(image.height == picture.height);
        paste(image, x, 0, picture);
        x += image.width;
    }
    return picture;
}

}  // namespace lampyris::evaluation
