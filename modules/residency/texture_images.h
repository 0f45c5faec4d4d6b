/// \file The scene's textures on the device: two 2D arrays, sRGB for colours and linear for data.
#pragma once

#include "gpu/image.h"
#include "gpu/staging.h"
#include "graph/frame.h"
#include "residency/texture_array.h"

namespace lampyris::residency {

class TextureImages {
 public:
    explicit TextureImages(gpu::Device& device) : device_(&device) {}

    /// Loads layers that changed; all of them where their number or size changed. Waits for the
    /// device where there is something to do. \return the bytes sent.
    core::Result<uint64_t> follow(const scene::SceneSnapshot& snapshot);

    [[nodiscard]] graph::Image importColour(graph::Frame& frame) const;
    [[nodiscard]] graph::Image importData(graph::Frame& frame) const;
    /// Grows whenever an image's layer changes: materials must be packed anew.
    [[nodiscard]] uint64_t layoutVersion() const { return layoutVersion_; }
    [[nodiscard]] const TextureLayers& layers() const { return plan_.layers; }
    [[nodiscard]] bool any() const { return !plan_.colour.empty() || !plan_.data.empty(); }
    [[nodiscard]] uint64_t bytes() const;

 private:
    core::Result<void> create(const TexturePlan& plan);
    core::Result<uint64_t> load(gpu::Staging& staging, const scene::SceneSnapshot& snapshot,
                                const gpu::Image& image, const std::vector<TextureLayer>& layers,
                                const std::vector<TextureLayer>& known) const;

    gpu::Device* device_;
    gpu::Image colour_;
    gpu::Image data_;
    TexturePlan plan_;
    bool created_ = false;
    uint64_t layoutVersion_ = 0;
};

}  // namespace lampyris::residency
