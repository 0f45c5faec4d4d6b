#include "shader_reload/interface_check.h"

#include <algorithm>
#include <array>

#include "embed/reflection.h"

namespace lampyris::shader_reload {
namespace {

// Every device has as much (Vulkan's least maxComputeSharedMemorySize).
constexpr uint64_t kSharedBytesEverywhere = 16384;
// Matrix, Shader, Sampled1D, Image1D, SampledBuffer, ImageBuffer, ImageQuery, DerivativeControl:
// capabilities of SPIR-V that every device of Vulkan 1.3 has.
constexpr std::array<uint32_t, 8> kCapabilitiesEverywhere{0, 1, 43, 44, 46, 47, 50, 51};

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

const embed::StageValue* at(const std::vector<embed::StageValue>& values, uint32_t location) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const auto& value) { return value.location == location; });
    return found == values.end() ? nullptr : &*found;
}

/// Each of `some` must be among `all` with its type.
core::Result<void> checkAmong(const char* what, const std::vector<embed::StageValue>& some,
                              const std::vector<embed::StageValue>& all, const char* otherwise) {
    for (const embed::StageValue& one : some) {
        const embed::StageValue* other = at(all, one.location);
        if (other == nullptr)
            return core::error("{} {} ({}) is {}", what, one.location, one.name, otherwise);
        if (other->type != one.type)
            return core::error("{} {} ({}): {} and {} differ", what, one.location, one.name,
                               one.type, other->type);
    }
    return {};
}

/// What comes in was bound, or handed on by the stage before; what goes out is taken.
core::Result<void> checkStages(const embed::Reflection& was, const embed::Reflection& is) {
    TRY_VOID(checkAmong("input", is.inputs, was.inputs, "new; nothing gives it"));
    TRY_VOID(checkAmong("output", is.outputs, was.outputs, "new; nothing takes it"));
    return checkAmong("output", was.outputs, is.outputs, "gone; the program takes it");
}

core::Result<void> checkDevice(const embed::Reflection& was, const embed::Reflection& is) {
    const auto has = [](const auto& all, uint32_t one) {
        return std::find(all.begin(), all.end(), one) != all.end();
    };
    for (const uint32_t capability : is.capabilities)
        if (!has(was.capabilities, capability) && !has(kCapabilitiesEverywhere, capability))
            return core::error("it needs SPIR-V's capability {}; the program did not ask for it",
                               capability);
    const uint64_t most = std::max(was.sharedBytes, kSharedBytesEverywhere);
    if (is.sharedBytes > most)
        return core::error("its workgroup shares {} bytes; {} are sure to be there", is.sharedBytes,
                           most);
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
    const auto before = embed::reflect(built.words);
    if (!before.ok()) return fail(before.error());
    const auto stages = checkStages(*before, *reflection);
    if (!stages.ok()) return fail(stages.error());
    const auto device = checkDevice(*before, *reflection);
    if (!device.ok()) return fail(device.error());
    return {};
}

}  // namespace lampyris::shader_reload
