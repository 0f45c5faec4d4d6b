#include "residency/texture_array.h"

#include <stb/stb_image_resize.h>

#include <algorithm>
#include <bit>
#include <optional>

#include "core/check.h"
#include "core/log.h"

namespace lampyris::residency {
namespace {

constexpr uint64_t kMostBytes = 1ull << 30;  // both arrays, of a 4 GiB process [chosen]

using Layers = std::vector<std::optional<TextureLayer>>;  // by image

void use(Layers& layers, const scene::SceneSnapshot& snapshot, const assets::TextureUse& use,
         bool srgb) {
    if (!use.present()) return;
    const auto image = static_cast<size_t>(use.image);
    const bool nearest = use.filter == assets::Filter::Nearest;
    const bool repeats = use.wrapU == assets::Wrap::Repeat && use.wrapV == assets::Wrap::Repeat;
    // The first use decides where an image is used in several ways.
    if (!layers[image])
        layers[image] = TextureLayer{static_cast<uint32_t>(image), snapshot.images[image].version,
                                     srgb, nearest, repeats};
}

std::vector<uint32_t> number(const Layers& layers, std::vector<TextureLayer>& used) {
    std::vector<uint32_t> numbers(layers.size(), shared::SCENE_NONE);
    for (size_t image = 0; image < layers.size(); ++image) {
        if (!layers[image]) continue;
        used.push_back(*layers[image]);
        numbers[image] = static_cast<uint32_t>(used.size());
    }
    return numbers;
}

uint32_t commonSize(const scene::SceneSnapshot& snapshot, const TexturePlan& plan) {
    uint32_t largest = 1;
    for (const auto* layers : {&plan.colour, &plan.data})
        for (const TextureLayer& layer : *layers) {
            const auto& image = *snapshot.images[layer.image].value;
            largest = std::max({largest, image.width, image.height});
        }
    uint32_t size = std::min(std::bit_ceil(largest), kLargestTexture);
    const uint64_t count = plan.colour.size() + plan.data.size() + 2;
    while (size > 1 && count * size * size * 4 > kMostBytes) size /= 2;
    if (size < largest)
        core::logWarning("textures of up to {} texels are resampled to {} × {}", largest, size,
                         size);
    return size;
}

}  // namespace

core::Result<TexturePlan> planTextures(const scene::SceneSnapshot& snapshot, uint32_t maxLayers) {
    Layers colour(snapshot.images.size()), data(snapshot.images.size());
    for (const auto& material : snapshot.materials) {
        use(colour, snapshot, material.value->baseColourTexture, true);
        use(colour, snapshot, material.value->emissiveTexture, true);
        use(data, snapshot, material.value->metallicRoughnessTexture, false);
        use(data, snapshot, material.value->normalTexture, false);
    }
    TexturePlan plan;
    plan.layers.colour = number(colour, plan.colour);
    plan.layers.data = number(data, plan.data);
    const size_t most = std::max(plan.colour.size(), plan.data.size()) + 1;
    if (most > maxLayers)
        return core::error(
            "the scene uses {} textures of one kind, the device's maxImageArrayLayers is {}",
            most - 1, maxLayers);
    plan.size = commonSize(snapshot, plan);
    return plan;
}

std::vector<uint8_t> resampled(const assets::TextureImage& image, const TextureLayer& layer,
                               uint32_t size) {
    if (image.width == size && image.height == size) return image.rgba;
    std::vector<uint8_t> pixels(static_cast<size_t>(size) * size * 4);
    // "Premultiplied" keeps alpha out of the colour's average, as a bilinear look-up does.
    const int done = stbir_resize_uint8_generic(
        image.rgba.data(), static_cast<int>(image.width), static_cast<int>(image.height), 0,
        pixels.data(), static_cast<int>(size), static_cast<int>(size), 0, 4, 3,
        STBIR_FLAG_ALPHA_PREMULTIPLIED, layer.repeats ? STBIR_EDGE_WRAP : STBIR_EDGE_CLAMP,
        layer.nearest ? STBIR_FILTER_BOX : STBIR_FILTER_TRIANGLE,
        layer.srgb ? STBIR_COLORSPACE_SRGB : STBIR_COLORSPACE_LINEAR, nullptr);
    CHECK(done == 1);
    return pixels;
}

}  // namespace lampyris::residency
