/// \file Images of many sizes → layers of one size: which images become layers, how large, and
/// their pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/result.h"
#include "residency/pack_scene.h"
#include "scene/snapshot.h"

namespace lampyris::residency {

/// One layer of a texture array.
struct TextureLayer {
    uint32_t image = 0;    ///< into the snapshot's images
    uint64_t version = 0;  ///< of the image
    bool srgb = false;     ///< colours are averaged in linear space
    bool nearest = false;  ///< used without filtering
    bool repeats = true;   ///< resampling wraps around the border
    bool operator==(const TextureLayer&) const = default;
};

/// What both arrays hold. Layer 0 of each is white, for materials without textures to bind.
struct TexturePlan {
    std::vector<TextureLayer> colour;  ///< layers 1, 2, …
    std::vector<TextureLayer> data;
    TextureLayers layers;  ///< by image
    uint32_t size = 1;     ///< texels a side, a power of two up to kLargestTexture
    bool operator==(const TexturePlan& other) const {
        return colour == other.colour && data == other.data && size == other.size;
    }
};

constexpr uint32_t kLargestTexture = 2048;

/// Only images that a material uses get a layer. \param maxLayers the device's maxImageArrayLayers;
/// the error names it. All layers get the size of the largest image, or less so that both arrays
/// stay under 1 GiB.
core::Result<TexturePlan> planTextures(const scene::SceneSnapshot& snapshot, uint32_t maxLayers);

/// The image at size × size, RGBA8; the same bytes where it already is.
[[nodiscard]] std::vector<uint8_t> resampled(const assets::TextureImage& image,
                                             const TextureLayer& layer, uint32_t size);

}  // namespace lampyris::residency
