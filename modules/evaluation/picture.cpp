#include "evaluation/picture.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/check.h"

namespace lampyris::evaluation {
namespace {

constexpr std::array kChannels{"red", "green", "blue"};

core::Error notFinite(const std::string& name, const core::Image& image, size_t value) {
    const size_t pixel = value / 3;
    return core::error("{}: {} in {} of the pixel at ({}, {})", name,
                       std::isnan(image.values[value]) ? "NaN" : "infinity", kChannels[value % 3],
                       pixel % image.width, pixel / image.width);
}

}  // namespace

core::Result<Picture> fromLinear(std::string name, const core::Image& image,
                                 const core::DisplayTransform& transform) {
    CHECK(image.channels != 2u);
    CHECK(image.channels <= 4u);
    core::Image linear(image.width, image.height, 3);
    for (size_t i = 0; i < linear.values.size(); ++i) {
        linear.values[i] = image.values[i / 3 * image.channels + (image.channels == 1 ? 0 : i % 3)];
        if (!std::isfinite(linear.values[i])) return notFinite(name, linear, i);
    }
    core::DisplayImage display = core::toDisplay(linear, transform);
    return Picture{std::move(name), std::move(display), std::move(linear)};
}

Picture fromDisplay(std::string name, core::DisplayImage display) {
    std::array<float, 256> decoded{};
    for (size_t v = 0; v < decoded.size(); ++v)
        decoded[v] = core::decodeSrgb(static_cast<float>(v) / 255.0f);
    core::Image linear(display.width, display.height, 3);
    for (size_t i = 0; i < linear.values.size(); ++i) linear.values[i] = decoded[display.values[i]];
    return Picture{std::move(name), std::move(display), std::move(linear)};
}

core::Result<void> checkComparable(const Picture& image, const Picture& reference) {
    const core::DisplayImage& a = image.display;
    const core::DisplayImage& b = reference.display;
    if (a.width != b.width || a.height != b.height)
        return core::error("{} is {}x{} and {} is {}x{}: pictures of one size are compared",
                           image.name, a.width, a.height, reference.name, b.width, b.height);
    if (a.values.empty())
        return core::error("{} and {} have no pixels", image.name, reference.name);
    return {};
}

}  // namespace lampyris::evaluation
