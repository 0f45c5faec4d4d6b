#include "execute/read_back.h"

#include <cstring>

#include "core/display.h"
#include "execute/barriers.h"
#include "execute/translate.h"
#include "gpu/staging.h"

namespace lampyris::execute {
namespace {

using graph::Format;

core::Result<void> mustBeKept(const graph::Frame& frame, const graph::CompiledGraph& graph,
                              uint32_t resource) {
    if (resource >= frame.resources().size())
        return core::error("read back: this frame has no resource {}", resource);
    const graph::ResourceInfo& info = frame.resources()[resource];
    const graph::CompiledResource& compiled = graph.resources[resource];
    if (compiled.accesses.empty())
        return core::error("read back: nothing writes {} in this frame", info.name);
    const bool kept =
        info.origin != graph::Origin::Transient || compiled.lastStep >= graph.steps.size();
    if (kept) return {};
    return core::error("read back: {} is not kept to the frame's end; make it an output",
                       info.name);
}

/// Every finite half exactly; NaN stays NaN.
float halfToFloat(uint16_t half) {
    const uint32_t sign = static_cast<uint32_t>(half & 0x8000u) << 16;
    const uint32_t exponent = half >> 10 & 0x1fu;
    const uint32_t mantissa = half & 0x3ffu;
    if (exponent == 0) {
        const float small = static_cast<float>(mantissa) * 0x1p-24f;
        return sign != 0 ? -small : small;
    }
    const uint32_t bits = exponent == 31 ? sign | 0x7f800000u | mantissa << 13
                                         : sign | (exponent + 112) << 23 | mantissa << 13;
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

template <typename T>
T valueAt(const RawImage& raw, size_t index) {
    T value;
    std::memcpy(&value, raw.bytes.data() + index * sizeof(T), sizeof(T));
    return value;
}

uint32_t channelsOf(Format format) {
    switch (format) {
        case Format::R32Uint:
        case Format::R32Float:
        case Format::D32Float:
            return 1;
        case Format::RG32Float:
            return 2;
        default:
            return 4;
    }
}

float channelAt(const RawImage& raw, size_t index) {
    switch (raw.desc.format) {
        case Format::R32Uint:
        case Format::RGBA32Uint:
            return static_cast<float>(valueAt<uint32_t>(raw, index));
        case Format::RGBA16Float:
            return halfToFloat(valueAt<uint16_t>(raw, index));
        case Format::RGBA8Unorm:
            return static_cast<float>(valueAt<uint8_t>(raw, index)) / 255.0f;
        case Format::BGRA8Unorm: {
            constexpr size_t kSwap[] = {2, 1, 0, 3};
            return static_cast<float>(valueAt<uint8_t>(raw, index / 4 * 4 + kSwap[index % 4])) /
                   255.0f;
        }
        case Format::RGBA8Srgb: {
            const float encoded = static_cast<float>(valueAt<uint8_t>(raw, index)) / 255.0f;
            return index % 4 == 3 ? encoded : core::decodeSrgb(encoded);
        }
        default:
            return valueAt<float>(raw, index);
    }
}

}  // namespace

core::Image toImage(const RawImage& raw) {
    core::Image image{raw.desc.extent.width, raw.desc.extent.height, channelsOf(raw.desc.format)};
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = channelAt(raw, i);
    return image;
}

core::Result<RawImage> readImage(gpu::Device& device, gpu::Commands& commands,
                                 const graph::Frame& frame, const graph::CompiledGraph& graph,
                                 const Resources& resources, graph::Image image) {
    TRY_VOID(mustBeKept(frame, graph, image.resource));
    const gpu::Image& source = resources.image(image.resource);
    const VkImageLayout layout = layoutOf(graph.resources[image.resource].endLayout);
    RawImage raw{frame.desc(image), {}};
    const uint64_t bytes = uint64_t{graph::bytesPerTexel(raw.desc.format)} * raw.desc.extent.width *
                           raw.desc.extent.height * raw.desc.layers;
    TRY(const gpu::Buffer target,
        gpu::Buffer::create(device, {bytes, gpu::MemoryUse::ReadBack, "read back"}));
    TRY(const VkCommandBuffer recorded, commands.begin());
    changeLayout(recorded, source, layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy region{};
    region.imageSubresource = {source.aspect(), 0, 0, raw.desc.layers};
    region.imageExtent = {raw.desc.extent.width, raw.desc.extent.height, 1};
    vkCmdCopyImageToBuffer(recorded, source.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           target.get(), 1, &region);
    changeLayout(recorded, source, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout);
    gpu::fullBarrier(recorded);
    TRY_VOID(commands.end());
    TRY_VOID(gpu::submitAndWait(device, commands));
    const auto mapped = target.mapped().first(bytes);
    raw.bytes.assign(mapped.begin(), mapped.end());
    return raw;
}

core::Result<std::vector<std::byte>> readBuffer(gpu::Device& device, const graph::Frame& frame,
                                                const graph::CompiledGraph& graph,
                                                const Resources& resources, graph::Buffer buffer) {
    TRY_VOID(mustBeKept(frame, graph, buffer.resource));
    TRY(gpu::Staging staging, gpu::Staging::create(device));
    return staging.read(resources.buffer(buffer.resource), 0, frame.desc(buffer).bytes);
}

}  // namespace lampyris::execute
