#include "execute/history_book.h"

#include "core/check.h"
#include "execute/barriers.h"
#include "execute/memory_model.h"
#include "execute/translate.h"
#include "gpu/commands.h"

namespace lampyris::execute {
namespace {

/// Everything that the format can do on the device, so that the contents survive a frame that uses
/// the image differently.
VkImageUsageFlags everyUsage(const gpu::Device& device, graph::Format format) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.physical(), formatOf(format), &properties);
    const VkFormatFeatureFlags features = properties.optimalTilingFeatures;
    VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                              VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if ((features & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT) != 0) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    if ((features & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) != 0)
        usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if ((features & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0)
        usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    return usage;
}

}  // namespace

bool HistoryBook::known(std::string_view name, const graph::ImageDesc& desc) const {
    const auto found = pairs_.find(name);
    return found != pairs_.end() && found->second.written && found->second.desc == desc;
}

void HistoryBook::forgetAll() {
    for (auto& [name, pair] : pairs_) pair.written = false;
}

bool HistoryBook::wouldChange(const graph::Frame& frame, const graph::CompiledGraph& graph) const {
    for (const graph::HistoryPair& history : graph.history) {
        const graph::ResourceInfo& info = frame.resources()[history.current];
        const auto found = pairs_.find(info.name);
        if (found != pairs_.end() && found->second.desc != info.image) return true;
    }
    return false;
}

core::Result<void> HistoryBook::prepare(const graph::Frame& frame,
                                        const graph::CompiledGraph& graph) {
    for (const graph::HistoryPair& history : graph.history) {
        const graph::ResourceInfo& info = frame.resources()[history.current];
        const auto found = pairs_.find(info.name);
        if (found != pairs_.end() && found->second.desc == info.image) continue;
        TRY(Pair pair, makePair(info));
        pairs_.insert_or_assign(info.name, std::move(pair));
    }
    return {};
}

core::Result<HistoryBook::Pair> HistoryBook::makePair(const graph::ResourceInfo& info) const {
    Pair pair;
    pair.desc = info.image;
    TRY(gpu::Commands clearing, gpu::Commands::create(*device_, "clear history"));
    TRY(const VkCommandBuffer commands, clearing.begin());
    for (gpu::Image& image : pair.images) {
        TRY(image, gpu::Image::create(
                       *device_, imageOptionsOf(info.image, everyUsage(*device_, info.image.format),
                                                info.name)));
        changeLayout(commands, image, VK_IMAGE_LAYOUT_UNDEFINED,
                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        clearImage(commands, image, VkClearValue{});
        changeLayout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                     layoutOf(graph::restLayout(info.image.format)));
    }
    TRY_VOID(clearing.end());
    TRY_VOID(gpu::submitAndWait(*device_, clearing));
    return pair;
}

const gpu::Image& HistoryBook::image(const graph::ResourceInfo& info) const {
    const auto found = pairs_.find(info.name);
    CHECK((found != pairs_.end()) == true);
    const Pair& pair = found->second;
    return pair.images[info.historyPrevious ? pair.previous : 1 - pair.previous];
}

void HistoryBook::turn(const graph::Frame& frame, const graph::CompiledGraph& graph) {
    for (const graph::HistoryPair& history : graph.history) {
        if (!history.currentWritten) continue;
        Pair& pair = pairs_.find(frame.resources()[history.current].name)->second;
        pair.previous = 1 - pair.previous;
        pair.written = true;
    }
}

}  // namespace lampyris::execute
