#include "reference/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/display.h"

namespace lampyris::reference {
namespace {

using ByteTable = std::array<float, 256>;

const ByteTable& tableOf(Encoding encoding) {
    static const std::array<ByteTable, 2> tables = [] {
        std::array<ByteTable, 2> made{};
        for (size_t i = 0; i < 256; ++i) {
            made[0][i] = static_cast<float>(i) / 255.0f;
            made[1][i] = core::decodeSrgb(made[0][i]);
        }
        return made;
    }();
    return tables[encoding == Encoding::Srgb ? 1 : 0];
}

/// One axis of a look-up: two texels and the second's weight.
struct Taps {
    uint32_t first, second;
    float weight;
};

uint32_t wrap(int64_t texel, uint32_t size, assets::Wrap mode) {
    const auto n = static_cast<int64_t>(size);
    if (mode == assets::Wrap::Clamp)
        return static_cast<uint32_t>(std::clamp<int64_t>(texel, 0, n - 1));
    const int64_t period = mode == assets::Wrap::Mirror ? 2 * n : n;
    const int64_t within = ((texel % period) + period) % period;
    return static_cast<uint32_t>(within < n ? within : period - 1 - within);
}

Taps tapsAt(float coordinate, uint32_t size, assets::Wrap mode, assets::Filter filter) {
    if (!std::isfinite(coordinate)) coordinate = 0.0f;
    // Beyond this a float has no fraction left. [chosen]
    const double at = std::clamp(coordinate, -1e7f, 1e7f) * static_cast<double>(size);
    if (filter == assets::Filter::Nearest) {
        const uint32_t texel = wrap(static_cast<int64_t>(std::floor(at)), size, mode);
        return {texel, texel, 0.0f};
    }
    const double corner = std::floor(at - 0.5);
    const auto texel = static_cast<int64_t>(corner);
    return {wrap(texel, size, mode), wrap(texel + 1, size, mode),
            static_cast<float>(at - 0.5 - corner)};
}

}  // namespace

glm::vec4 lookUp(const assets::TextureImage& image, const assets::TextureUse& use, glm::vec2 uv,
                 Encoding encoding) {
    if (image.width == 0 || image.height == 0) return glm::vec4(1.0f);
    const ByteTable& colour = tableOf(encoding);
    const ByteTable& alpha = tableOf(Encoding::Linear);
    const auto texel = [&](uint32_t x, uint32_t y) {
        const uint8_t* rgba = &image.rgba[4 * (size_t{y} * image.width + x)];
        return glm::vec4(colour[rgba[0]], colour[rgba[1]], colour[rgba[2]], alpha[rgba[3]]);
    };
    const Taps x = tapsAt(uv.x, image.width, use.wrapU, use.filter);
    const Taps y = tapsAt(uv.y, image.height, use.wrapV, use.filter);
    if (use.filter == assets::Filter::Nearest) return texel(x.first, y.first);
    return glm::mix(glm::mix(texel(x.first, y.first), texel(x.second, y.first), x.weight),
                    glm::mix(texel(x.first, y.second), texel(x.second, y.second), x.weight),
                    y.weight);
}

}  // namespace lampyris::reference
