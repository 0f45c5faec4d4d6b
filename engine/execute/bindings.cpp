#include "execute/bindings.h"

#include <algorithm>
#include <string>

#include "execute/recording.h"
#include "execute/translate.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::execute {
namespace {

using graph::Access;
using graph::SlotKind;

/// Where the structs live that VkWriteDescriptorSet points at.
struct Descriptor {
    VkDescriptorBufferInfo buffer{};
    VkDescriptorImageInfo image{};
    VkBufferView view = VK_NULL_HANDLE;
};

bool isAttachment(Access access) {
    return access == Access::ColorWrite || access == Access::DepthWrite ||
           access == Access::DepthRead;
}

const graph::Use* findUse(const graph::Node& node, uint32_t slot) {
    const auto found = std::find_if(node.uses.begin(), node.uses.end(), [&](const graph::Use& use) {
        return use.slot == slot && !isAttachment(use.access);
    });
    return found == node.uses.end() ? nullptr : &*found;
}

const graph::UniformData* findUniform(const graph::Node& node, uint32_t slot) {
    const auto found =
        std::find_if(node.uniforms.begin(), node.uniforms.end(),
                     [&](const graph::UniformData& data) { return data.slot == slot; });
    return found == node.uniforms.end() ? nullptr : &*found;
}

struct Limit {
    const char* name;
    uint64_t value;
};

core::Result<void> describeBuffer(const Recording& recording, const graph::Use& use, SlotKind kind,
                                  Descriptor& descriptor) {
    const VkPhysicalDeviceLimits& limits = recording.device.limits().core;
    const graph::ResourceInfo& info = recording.frame.resources()[use.resource];
    const gpu::Buffer& buffer = recording.resources.buffer(use.resource);
    const uint64_t bytes = use.bytes == 0 ? info.buffer.bytes - use.offset : use.bytes;
    const bool uniform = kind == SlotKind::UniformBuffer;
    const bool texels =
        kind == SlotKind::UniformTexelBuffer || kind == SlotKind::StorageTexelBuffer;
    const Limit alignment =
        texels ? Limit{"minTexelBufferOffsetAlignment", limits.minTexelBufferOffsetAlignment}
        : uniform
            ? Limit{"minUniformBufferOffsetAlignment", limits.minUniformBufferOffsetAlignment}
            : Limit{"minStorageBufferOffsetAlignment", limits.minStorageBufferOffsetAlignment};
    if (use.offset % alignment.value != 0)
        return core::error("{}: offset {} is no multiple of the device's {}, {}", info.name,
                           use.offset, alignment.name, alignment.value);
    if (texels) {
        TRY(descriptor.view, buffer.view(formatOf(use.texelFormat),
                                         graph::bytesPerTexel(use.texelFormat), use.offset, bytes));
        return {};
    }
    const Limit range = uniform ? Limit{"maxUniformBufferRange", limits.maxUniformBufferRange}
                                : Limit{"maxStorageBufferRange", limits.maxStorageBufferRange};
    if (bytes > range.value)
        return core::error("{}: {} bytes are more than the device's {}, {}", info.name, bytes,
                           range.name, range.value);
    descriptor.buffer = {buffer.get(), use.offset, bytes};
    return {};
}

void describeImage(const Recording& recording, const graph::Use& use, Descriptor& descriptor) {
    graph::AccessSet access;
    access.add(use.access);
    const graph::ResourceInfo& info = recording.frame.resources()[use.resource];
    const auto layout = graph::layoutFor(access, info.image.format);
    descriptor.image.imageView = recording.resources.image(use.resource).view();
    descriptor.image.imageLayout = layoutOf(layout.value_or(graph::Layout::General));
    if (use.access == Access::Sampled)
        descriptor.image.sampler = recording.samplers.get(use.filtering, use.addressing);
}

core::Result<void> describe(Recording& recording, const graph::Node& node,
                            const graph::ShaderSlot& slot, Descriptor& descriptor) {
    if (const graph::UniformData* data = findUniform(node, slot.slot)) {
        TRY(const auto place, recording.slot.uniforms.add(data->bytes, data->storage));
        descriptor.buffer = {place.buffer, place.offset, place.bytes};
        return {};
    }
    const graph::Use* use = findUse(node, slot.slot);
    if (use == nullptr) return core::error("nothing is declared for it");
    if (!use->isImage) return describeBuffer(recording, *use, slot.kind, descriptor);
    describeImage(recording, *use, descriptor);
    return {};
}

}  // namespace

core::Result<Samplers> Samplers::create(const gpu::Device& device) {
    Samplers samplers;
    for (size_t i = 0; i < samplers.samplers_.size(); ++i) {
        TRY(samplers.samplers_[i],
            gpu::createSampler(device, {.linear = (i & 1) != 0, .repeat = (i & 2) != 0}));
    }
    return samplers;
}

VkSampler Samplers::get(graph::Filtering filtering, graph::Addressing addressing) const {
    return samplers_[(filtering == graph::Filtering::Linear ? 1 : 0) +
                     (addressing == graph::Addressing::Repeat ? 2 : 0)]
        .get();
}

core::Result<VkDescriptorSet> makeDescriptorSet(Recording& recording, const graph::Node& node,
                                                const SetLayout& layout) {
    TRY(VkDescriptorSet set, recording.slot.descriptors.allocate(layout.set.get()));
    std::vector<Descriptor> descriptors(layout.slots.size());
    std::vector<VkWriteDescriptorSet> writes;
    for (size_t i = 0; i < layout.slots.size(); ++i) {
        const graph::ShaderSlot& slot = layout.slots[i];
        const auto described = describe(recording, node, slot, descriptors[i]);
        if (!described.ok())
            return core::error("node {}, slot {} ({}): {}", node.name, slot.slot, slot.name,
                               described.error().message);
        auto write =
            gpu::vulkanStruct<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        write.dstSet = set;
        write.dstBinding = slot.slot;
        write.descriptorCount = 1;
        write.descriptorType = descriptorTypeOf(slot.kind);
        write.pBufferInfo = &descriptors[i].buffer;
        write.pImageInfo = &descriptors[i].image;
        write.pTexelBufferView = &descriptors[i].view;
        writes.push_back(write);
    }
    vkUpdateDescriptorSets(recording.device.get(), static_cast<uint32_t>(writes.size()),
                           writes.data(), 0, nullptr);
    return set;
}

}  // namespace lampyris::execute
