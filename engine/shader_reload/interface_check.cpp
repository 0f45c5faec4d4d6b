#include "shader_reload/interface_check.h"

#include <algorithm>

#include "embed/reflection.h"

namespace lampyris::shader_reload {
namespace {

const char* name(graph::SlotKind kind) {
    switch (kind) {
        case graph::SlotKind::StorageBuffer:
            return "StorageBuffer";
        case graph::SlotKind::UniformBuffer:
            return "UniformBuffer";
        case graph::SlotKind::UniformTexelBuffer:
            return "UniformTexelBuffer";
        case graph::SlotKind::StorageTexelBuffer:
            return "StorageTexelBuffer";
        case graph::SlotKind::SampledImage:
            return "SampledImage";
        case graph::SlotKind::StorageImage:
            break;
    }
    return "StorageImage";
}

const char* access(bool reads, bool writes) {
    if (reads && writes) return "read and written";
    if (reads) return "read";
    return writes ? "written" : "not used";
}

/// Whether the slot is, in the new words, what it was in the old.
core::Result<void> checkSlot(const graph::ShaderSlot& was, const embed::Slot& is) {
    if (is.kind != name(was.kind))
        return core::error("slot {} ({}) is a {}; the program binds a {}", was.slot, is.name,
                           is.kind, name(was.kind));
    if (is.reads != was.reads || is.writes != was.writes)
        return core::error("slot {} ({}) is {}; the program's node has it {}", was.slot, is.name,
                           access(is.reads, is.writes), access(was.reads, was.writes));
    return {};
}

core::Result<void> checkSlots(std::span<const graph::ShaderSlot> built,
                              const std::vector<embed::Slot>& slots) {
    for (const graph::ShaderSlot& was : built) {
        const auto is = std::find_if(slots.begin(), slots.end(), [&](const embed::Slot& slot) {
            return slot.slot == was.slot;
        });
        if (is == slots.end())
            return core::error("slot {} ({}) is gone; the program binds it", was.slot, was.name);
        TRY_VOID(checkSlot(was, *is));
    }
    for (const embed::Slot& is : slots)
        if (std::none_of(built.begin(), built.end(),
                         [&](const graph::ShaderSlot& was) { return was.slot == is.slot; }))
            return core::error("slot {} ({}) is new; the program binds nothing there", is.slot,
                               is.name);
    return {};
}

}  // namespace

core::Result<void> checkInterface(const graph::Shader& built, std::span<const uint32_t> words) {
    const auto fail = [&](const core::Error& why) {
        return core::error("{}: {}", built.source, why.message);
    };
    const auto reflection = embed::reflect(words);
    if (!reflection.ok()) return fail(reflection.error());
    const auto slots = checkSlots(built.slots, reflection->slots);
    if (!slots.ok()) return fail(slots.error());
    const auto& size = reflection->workgroupSize;
    const auto& was = built.workgroupSize;
    if (size != was)
        return core::error("{}: its workgroup is {}x{}x{}; the program counts on {}x{}x{}",
                           built.source, size[0], size[1], size[2], was[0], was[1], was[2]);
    if (reflection->pushConstantBytes != built.pushConstantBytes)
        return core::error("{}: it takes {} bytes of push constants; the program gives {}",
                           built.source, reflection->pushConstantBytes, built.pushConstantBytes);
    return {};
}

}  // namespace lampyris::shader_reload
