#include "execute/read_back.h"

#include "execute/barriers.h"
#include "execute/translate.h"
#include "gpu/buffer.h"

namespace lampyris::execute {
namespace {

/// Where one resource lies in the host's buffer.
struct Piece {
    uint32_t resource = 0;
    uint64_t offset = 0;
    uint64_t bytes = 0;
};

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

uint64_t bytesOf(const graph::ResourceInfo& info) {
    const graph::ImageDesc& image = info.image;
    return info.isImage ? uint64_t{graph::bytesPerTexel(image.format)} * image.extent.width *
                              image.extent.height * image.layers
                        : info.buffer.bytes;
}

void recordCopy(VkCommandBuffer commands, const gpu::Image& source, VkImageLayout layout,
                const gpu::Buffer& target, uint64_t offset) {
    changeLayout(commands, source, layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    const gpu::ImageOptions& options = source.options();
    VkBufferImageCopy region{};
    region.bufferOffset = offset;
    region.imageSubresource = {source.aspect(), 0, 0, options.layers};
    region.imageExtent = {options.extent.width, options.extent.height, 1};
    vkCmdCopyImageToBuffer(commands, source.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           target.get(), 1, &region);
    changeLayout(commands, source, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout);
}

}  // namespace

core::Result<std::vector<std::vector<std::byte>>> readBack(gpu::Device& device,
                                                           gpu::Commands& commands,
                                                           const graph::Frame& frame,
                                                           const graph::CompiledGraph& graph,
                                                           const Resources& resources,
                                                           std::span<const uint32_t> wanted) {
    constexpr uint64_t kAlignment = 16;  // of every texel format
    std::vector<Piece> pieces;
    uint64_t total = 0;
    for (const uint32_t resource : wanted) {
        TRY_VOID(mustBeKept(frame, graph, resource));
        const uint64_t bytes = bytesOf(frame.resources()[resource]);
        pieces.push_back({resource, total, bytes});
        total += (bytes + kAlignment - 1) / kAlignment * kAlignment;
    }
    std::vector<std::vector<std::byte>> contents;
    if (pieces.empty()) return contents;
    TRY(const gpu::Buffer target,
        gpu::Buffer::create(device, {total, gpu::MemoryUse::ReadBack, "read back"}));
    TRY(const VkCommandBuffer recorded, commands.begin());
    gpu::fullBarrier(recorded);
    for (const Piece& piece : pieces) {
        if (frame.resources()[piece.resource].isImage) {
            recordCopy(recorded, resources.image(piece.resource),
                       layoutOf(graph.resources[piece.resource].endLayout), target, piece.offset);
            continue;
        }
        const VkBufferCopy region{0, piece.offset, piece.bytes};
        vkCmdCopyBuffer(recorded, resources.buffer(piece.resource).get(), target.get(), 1, &region);
    }
    gpu::fullBarrier(recorded);
    TRY_VOID(commands.end());
    TRY_VOID(gpu::submitAndWait(device, commands));
    for (const Piece& piece : pieces) {
        const auto mapped = target.mapped().subspan(piece.offset, piece.bytes);
        contents.emplace_back(mapped.begin(), mapped.end());
    }
    return contents;
}

}  // namespace lampyris::execute
