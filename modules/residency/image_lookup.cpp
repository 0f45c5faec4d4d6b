#include "residency/image_lookup.h"

#include <algorithm>
#include <array>

#include "core/display.h"

namespace lampyris::residency {
namespace {

/// The texel an index means beyond the border.
int wrapped(int texel, int size, assets::Wrap wrap) {
    switch (wrap) {
        case assets::Wrap::Clamp:
            return std::clamp(texel, 0, size - 1);
        case assets::Wrap::Mirror: {
            const int period = ((texel % (2 * size)) + 2 * size) % (2 * size);
            return period < size ? period : 2 * size - 1 - period;
        }
        case assets::Wrap::Repeat:
            break;
    }
    return ((texel % size) + size) % size;
}

const std::array<float, 256>& linearTable() {
    static const auto table = [] {
        std::array<float, 256> values{};
        for (size_t i = 0; i < values.size(); ++i)
            values[i] = core::decodeSrgb(static_cast<float>(i) / 255.0f);
        return values;
    }();
    return table;
}

/// The part of a coordinate that matters, so that it fits an int: its period, or near the borders.
float reduced(float u, assets::Wrap wrap) {
    if (!std::isfinite(u)) return 0.0f;
    if (wrap == assets::Wrap::Clamp) return std::clamp(u, -1.0f, 2.0f);
    return u - 2.0f * std::floor(0.5f * u);
}

}  // namespace

glm::vec3 lookUpSrgb(const assets::TextureImage& image, const assets::TextureUse& use,
                     glm::vec2 uv) {
    const glm::ivec2 size(image.width, image.height);
    const auto texel = [&](int x, int y) {
        x = wrapped(x, size.x, use.wrapU);
        y = wrapped(y, size.y, use.wrapV);
        const uint8_t* rgba =
            &image.rgba[4 * (static_cast<size_t>(y) * image.width + static_cast<size_t>(x))];
        const auto& linear = linearTable();
        return glm::vec3(linear[rgba[0]], linear[rgba[1]], linear[rgba[2]]);
    };
    const glm::vec2 at =
        glm::vec2(reduced(uv.x, use.wrapU), reduced(uv.y, use.wrapV)) * glm::vec2(size);
    if (use.filter == assets::Filter::Nearest)
        return texel(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
    const glm::vec2 corner = glm::floor(at - 0.5f);
    const glm::vec2 weight = at - 0.5f - corner;
    const auto x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), weight.x),
                    glm::mix(texel(x, y + 1), texel(x + 1, y + 1), weight.x), weight.y);
}

}  // namespace lampyris::residency
