#include <algorithm>
#include <cstring>
#include <map>
#include <optional>

#include "execute/recording.h"
#include "execute/translate.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::execute {
namespace {

using gpu::vulkanStruct;
using graph::Access;

VkRenderingAttachmentInfo attachmentOf(const Recording& recording, const graph::Use& use) {
    graph::AccessSet access;
    access.add(use.access);
    const graph::ResourceInfo& info = recording.frame.resources()[use.resource];
    auto attachment =
        vulkanStruct<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    attachment.imageView = recording.resources.image(use.resource).view();
    attachment.imageLayout =
        layoutOf(graph::layoutFor(access, info.image.format).value_or(graph::Layout::General));
    attachment.loadOp = use.clears ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    // Storing counts as a write, even of what was only tested.
    attachment.storeOp = use.access == Access::DepthRead ? VK_ATTACHMENT_STORE_OP_NONE
                                                         : VK_ATTACHMENT_STORE_OP_STORE;
    if (graph::isDepth(info.image.format))
        attachment.clearValue.depthStencil.depth = use.clearColour[0];
    else  // the bits are right for floats and for uints
        std::memcpy(&attachment.clearValue.color, use.clearColour.data(), sizeof use.clearColour);
    return attachment;
}

struct Attachments {
    std::vector<VkRenderingAttachmentInfo> colours;  ///< by location
    std::optional<VkRenderingAttachmentInfo> depth;
    AttachmentFormats formats;
};

core::Result<Attachments> collectAttachments(const Recording& recording, const graph::Node& node) {
    Attachments attachments;
    const uint32_t most = recording.device.limits().core.maxColorAttachments;
    for (const graph::Use& use : node.uses) {
        if (!use.isImage) continue;
        const VkFormat format = formatOf(recording.frame.resources()[use.resource].image.format);
        if (use.access == Access::DepthWrite || use.access == Access::DepthRead) {
            attachments.depth = attachmentOf(recording, use);
            attachments.formats.depth = format;
        }
        if (use.access != Access::ColorWrite) continue;
        if (use.slot >= most)
            return core::error(
                "node {}: colour attachment {} is beyond the device's "
                "maxColorAttachments, {}",
                node.name, use.slot, most);
        if (use.slot >= attachments.colours.size()) {
            // A location that nothing is written to has an attachment without a view.
            attachments.colours.resize(use.slot + 1,
                                       vulkanStruct<VkRenderingAttachmentInfo>(
                                           VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO));
            attachments.formats.colours.resize(use.slot + 1, VK_FORMAT_UNDEFINED);
        }
        attachments.colours[use.slot] = attachmentOf(recording, use);
        attachments.formats.colours[use.slot] = format;
    }
    return attachments;
}

void beginRendering(VkCommandBuffer commands, const graph::Node& node,
                    const Attachments& attachments) {
    const VkRect2D area{{0, 0}, {node.renderExtent.width, node.renderExtent.height}};
    auto info = vulkanStruct<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    info.renderArea = area;
    info.layerCount = 1;
    info.colorAttachmentCount = static_cast<uint32_t>(attachments.colours.size());
    info.pColorAttachments = attachments.colours.data();
    info.pDepthAttachment = attachments.depth ? &*attachments.depth : nullptr;
    vkCmdBeginRendering(commands, &info);
    const VkViewport viewport{
        0.0f, 0.0f, static_cast<float>(area.extent.width), static_cast<float>(area.extent.height),
        0.0f, 1.0f};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
}

/// Keeps the first error: the callback that draws returns nothing.
class Drawer final : public graph::RasterCommands {
 public:
    Drawer(Recording& recording, const graph::Node& node, const AttachmentFormats& formats)
        : recording_(recording), node_(node), formats_(formats) {}

    void draw(const graph::Draw& draw) override {
        if (!result_.ok()) return;
        const auto drawn = tryDraw(draw);
        if (!drawn.ok()) result_ = core::error("node {}: {}", node_.name, drawn.error().message);
    }
    [[nodiscard]] const core::Result<void>& result() const { return result_; }

 private:
    core::Result<void> tryDraw(const graph::Draw& draw) {
        TRY_VOID(bindProgram(*draw.pipeline));
        TRY_VOID(push(draw));
        TRY_VOID(bindStreams(draw));
        const VkCommandBuffer commands = recording_.commands;
        setScissor(draw);
        if (!draw.indices.valid()) {
            vkCmdDraw(commands, draw.count, draw.instances, 0, 0);
            return {};
        }
        TRY_VOID(mustBeDeclared(draw.indices, Access::IndexRead));
        vkCmdBindIndexBuffer(commands, recording_.resources.buffer(draw.indices.resource).get(),
                             draw.indexOffsetBytes, VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexed(commands, draw.count, draw.instances, 0, 0, 0);
        return {};
    }

    core::Result<void> bindProgram(const graph::RasterPipeline& pipeline) {
        if (boundState_ == &pipeline) return {};
        TRY(const Program program, recording_.pipelines.raster(pipeline, formats_));
        VkDescriptorSet& set = sets_[program.layout];
        if (set == VK_NULL_HANDLE) {
            TRY(set, makeDescriptorSet(recording_, node_, *program.layout));
        }
        vkCmdBindPipeline(recording_.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, program.pipeline);
        vkCmdBindDescriptorSets(recording_.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                                program.layout->pipeline.get(), 0, 1, &set, 0, nullptr);
        layout_ = program.layout;
        boundState_ = &pipeline;
        return {};
    }

    void setScissor(const graph::Draw& draw) {
        const graph::Extent& all = node_.renderExtent;
        const graph::Rectangle cut =
            draw.scissor.value_or(graph::Rectangle{0, 0, all.width, all.height});
        const VkRect2D area{{static_cast<int32_t>(cut.x), static_cast<int32_t>(cut.y)},
                            {cut.width, cut.height}};
        vkCmdSetScissor(recording_.commands, 0, 1, &area);
    }

    core::Result<void> push(const graph::Draw& draw) {
        if (layout_->pushBytes == 0) return {};
        if (draw.pushBytes < layout_->pushBytes)
            return core::error("a draw pushes {} bytes, its shaders take {}", draw.pushBytes,
                               layout_->pushBytes);
        vkCmdPushConstants(recording_.commands, layout_->pipeline.get(), layout_->pushStages, 0,
                           layout_->pushBytes, draw.push.data());
        return {};
    }

    core::Result<void> bindStreams(const graph::Draw& draw) {
        for (uint32_t i = 0; i < draw.streams.size(); ++i) {
            TRY_VOID(mustBeDeclared(draw.streams[i], Access::VertexRead));
            const VkBuffer buffer = recording_.resources.buffer(draw.streams[i].resource).get();
            const VkDeviceSize offset = i < draw.streamOffsets.size() ? draw.streamOffsets[i] : 0;
            vkCmdBindVertexBuffers(recording_.commands, i, 1, &buffer, &offset);
        }
        return {};
    }

    core::Result<void> mustBeDeclared(graph::Buffer buffer, Access access) const {
        const bool declared =
            std::any_of(node_.uses.begin(), node_.uses.end(), [&](const graph::Use& use) {
                return use.resource == buffer.resource && use.access == access;
            });
        if (declared) return {};
        return core::error("draws with a buffer that it never declared as {}", graph::name(access));
    }

    Recording& recording_;
    const graph::Node& node_;
    const AttachmentFormats& formats_;
    const graph::RasterPipeline* boundState_ = nullptr;
    const SetLayout* layout_ = nullptr;
    std::map<const SetLayout*, VkDescriptorSet> sets_;
    core::Result<void> result_;
};

}  // namespace

core::Result<void> recordRaster(Recording& recording, const graph::Node& node) {
    TRY(const Attachments attachments, collectAttachments(recording, node));
    beginRendering(recording.commands, node, attachments);
    Drawer drawer{recording, node, attachments.formats};
    if (node.record) node.record(drawer);
    vkCmdEndRendering(recording.commands);
    return drawer.result();
}

}  // namespace lampyris::execute
