#include "residency/texture_images.h"

namespace lampyris::residency {
namespace {

core::Result<gpu::Image> createArray(gpu::Device& device, VkFormat format, size_t layers,
                                     uint32_t size, const char* name) {
    return gpu::Image::create(
        device, {.format = format,
                 .extent = {size, size},
                 .layers = static_cast<uint32_t>(layers) + 1,
                 .array = true,
                 .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                 .name = name});
}

graph::Image importArray(graph::Frame& frame, const gpu::Image& image, graph::Format format) {
    const gpu::ImageOptions& options = image.options();
    return frame.importImage(
        options.name, {format, {options.extent.width, options.extent.height}, options.layers, true},
        {&image}, graph::Access::Sampled);
}

}  // namespace

core::Result<void> TextureImages::create(const TexturePlan& plan) {
    TRY_VOID(device_->waitIdle());
    TRY(colour_, createArray(*device_, VK_FORMAT_R8G8B8A8_SRGB, plan.colour.size(), plan.size,
                             "colour textures"));
    TRY(data_, createArray(*device_, VK_FORMAT_R8G8B8A8_UNORM, plan.data.size(), plan.size,
                           "data textures"));
    return {};
}

core::Result<uint64_t> TextureImages::load(gpu::Staging& staging,
                                           const scene::SceneSnapshot& snapshot,
                                           const gpu::Image& image,
                                           const std::vector<TextureLayer>& layers,
                                           const std::vector<TextureLayer>& known) const {
    const uint32_t size = image.options().extent.width;
    uint64_t sum = 0;
    for (uint32_t i = 0; i < layers.size(); ++i) {
        if (i < known.size() && layers[i] == known[i]) continue;
        const auto pixels = resampled(*snapshot.images[layers[i].image].value, layers[i], size);
        TRY_VOID(staging.write(image, i + 1, std::as_bytes(std::span(pixels))));
        sum += pixels.size();
    }
    return sum;
}

core::Result<uint64_t> TextureImages::follow(const scene::SceneSnapshot& snapshot) {
    TRY(TexturePlan plan, planTextures(snapshot, device_->limits().core.maxImageArrayLayers));
    if (created_ && plan == plan_) return uint64_t{0};
    ++layoutVersion_;
    const bool fits = created_ && plan.size == plan_.size &&
                      plan.colour.size() == plan_.colour.size() &&
                      plan.data.size() == plan_.data.size();
    TRY_VOID(device_->waitIdle());
    TRY(gpu::Staging staging, gpu::Staging::create(*device_));
    if (!fits) {
        TRY_VOID(create(plan));
        const std::vector<uint8_t> white(static_cast<size_t>(plan.size) * plan.size * 4, 255);
        for (const gpu::Image* image : {&colour_, &data_})
            TRY_VOID(staging.write(*image, 0, std::as_bytes(std::span(white))));
        plan_ = {};
    }
    TRY(const uint64_t colourBytes, load(staging, snapshot, colour_, plan.colour, plan_.colour));
    TRY(const uint64_t dataBytes, load(staging, snapshot, data_, plan.data, plan_.data));
    TRY_VOID(staging.flush());
    plan_ = std::move(plan);
    created_ = true;
    return colourBytes + dataBytes;
}

graph::Image TextureImages::importColour(graph::Frame& frame) const {
    return importArray(frame, colour_, graph::Format::RGBA8Srgb);
}

graph::Image TextureImages::importData(graph::Frame& frame) const {
    return importArray(frame, data_, graph::Format::RGBA8Unorm);
}

uint64_t TextureImages::bytes() const {
    const uint64_t layers = plan_.colour.size() + plan_.data.size() + 2;
    return created_ ? layers * plan_.size * plan_.size * 4 : 0;
}

}  // namespace lampyris::residency
