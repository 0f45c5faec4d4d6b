#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "graph/verify.h"

namespace lampyris::graph {
namespace {

/// What the node says of one slot.
struct Declared {
    SlotKind kind = SlotKind::UniformBuffer;
    bool writes = false;
    std::string what;  ///< the resource's name
};

/// What the node's shaders, together, say of it.
struct Reflected {
    const Shader* shader = nullptr;
    ShaderSlot slot;
};

const char* name(SlotKind kind) {
    static constexpr std::array<const char*, 6> kNames{
        "storage buffer",       "uniform buffer", "uniform texel buffer",
        "storage texel buffer", "sampled image",  "storage image"};
    return kNames[static_cast<size_t>(kind)];
}

bool bindsSlot(const Use& use) {
    switch (use.access) {
        case Access::Uniform:
        case Access::TexelRead:
        case Access::StorageRead:
        case Access::StorageWrite:
        case Access::StorageUpdate:
        case Access::Sampled:
            return true;
        default:
            return false;
    }
}

SlotKind kindOf(const Use& use) {
    if (use.access == Access::Uniform) return SlotKind::UniformBuffer;
    if (use.access == Access::TexelRead) return SlotKind::UniformTexelBuffer;
    if (use.access == Access::Sampled) return SlotKind::SampledImage;
    if (use.isImage) return SlotKind::StorageImage;
    const bool texels = use.texelFormat != Format::Undefined;
    return texels ? SlotKind::StorageTexelBuffer : SlotKind::StorageBuffer;
}

core::Error twice(const Node& node, uint32_t slot, const std::string& what) {
    return core::error("render graph: node '{}' declares slot {} twice, the second time for '{}'",
                       node.name, slot, what);
}

core::Result<std::map<uint32_t, Declared>> declaredSlots(const Frame& frame, const Node& node) {
    std::map<uint32_t, Declared> slots;
    std::set<uint32_t> locations;
    bool hasDepth = false;
    for (const Use& use : node.uses) {
        const std::string& what = frame.resources()[use.resource].name;
        if (use.access == Access::ColorWrite && !locations.insert(use.slot).second) {
            return twice(node, use.slot, what);
        }
        if (use.access == Access::DepthWrite || use.access == Access::DepthRead) {
            if (hasDepth) {
                return core::error("render graph: node '{}' has a second depth attachment, '{}'",
                                   node.name, what);
            }
            hasDepth = true;
        }
        if (!bindsSlot(use)) continue;
        const Declared declared{kindOf(use), writes(use.access), what};
        if (!slots.try_emplace(use.slot, declared).second) return twice(node, use.slot, what);
    }
    for (const UniformData& data : node.uniforms) {
        const Declared declared{data.storage ? SlotKind::StorageBuffer : SlotKind::UniformBuffer,
                                false, "uniform data"};
        if (!slots.try_emplace(data.slot, declared).second) {
            return twice(node, data.slot, declared.what);
        }
    }
    return slots;
}

core::Result<std::map<uint32_t, Reflected>> reflectedSlots(const Node& node) {
    std::map<uint32_t, Reflected> slots;
    std::vector<const Shader*> shaders = node.rasterShaders;
    if (node.shader != nullptr) shaders.push_back(node.shader);
    for (const Shader* shader : shaders) {
        for (const ShaderSlot& slot : shader->slots) {
            const auto [place, isNew] = slots.try_emplace(slot.slot, Reflected{shader, slot});
            ShaderSlot& known = place->second.slot;
            if (!isNew && known.kind != slot.kind) {
                return core::error(
                    "render graph: node '{}': slot {} is a {} in shader {} and a {} in {}",
                    node.name, slot.slot, name(known.kind), place->second.shader->name,
                    name(slot.kind), shader->name);
            }
            known.writes = known.writes || slot.writes;
        }
    }
    return slots;
}

core::Result<void> agree(const Node& node, uint32_t number, const Declared& declared,
                         const Reflected& reflected) {
    const ShaderSlot& slot = reflected.slot;
    if (declared.kind != slot.kind) {
        return core::error(
            "render graph: node '{}' declares '{}' in slot {} as a {}, but shader {} has a {} "
            "there ({})",
            node.name, declared.what, number, name(declared.kind), reflected.shader->name,
            name(slot.kind), slot.name);
    }
    if (slot.writes && !declared.writes) {
        return core::error(
            "render graph: node '{}' declares '{}' in slot {} as read, but shader {} writes it "
            "({}): a "
            "write nobody declared",
            node.name, declared.what, number, reflected.shader->name, slot.name);
    }
    if (declared.writes && !slot.writes) {
        return core::error(
            "render graph: node '{}' declares '{}' in slot {} as written, but shader {} only reads "
            "it ({})",
            node.name, declared.what, number, reflected.shader->name, slot.name);
    }
    return {};
}

core::Result<void> pushFits(const Node& node) {
    if (node.shader == nullptr) return {};
    const size_t wanted = node.shader->pushConstantBytes;
    const bool fits = wanted == 0 ? node.push.empty() : node.push.size() >= wanted;
    if (fits) return {};
    return core::error("render graph: node '{}' pushes {} bytes, but shader {} takes {}", node.name,
                       node.push.size(), node.shader->name, wanted);
}

}  // namespace

core::Result<void> verifySlots(const Frame& frame, const Node& node) {
    TRY(const auto declared, declaredSlots(frame, node));
    TRY(const auto reflected, reflectedSlots(node));
    for (const auto& [number, entry] : declared) {
        const auto found = reflected.find(number);
        if (found == reflected.end()) {
            return core::error(
                "render graph: node '{}' declares '{}' in slot {}, which no shader of it has",
                node.name, entry.what, number);
        }
        TRY_VOID(agree(node, number, entry, found->second));
    }
    for (const auto& [number, entry] : reflected) {
        if (declared.contains(number)) continue;
        return core::error("render graph: node '{}' never declares slot {} ({}) of shader {}{}",
                           node.name, number, entry.slot.name, entry.shader->name,
                           entry.slot.writes ? ": a write nobody declared" : "");
    }
    return pushFits(node);
}

}  // namespace lampyris::graph
