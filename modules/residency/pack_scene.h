/// \file SceneSnapshot → the structs of shaders/shared/scene.h, on the CPU.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/snapshot.h"
#include "shared/scene.h"

namespace lampyris::residency {

/// An instance's transforms as traversal and drawing use them.
struct Placement {
    glm::mat4 objectToWorld{1.0f};
    glm::mat4 worldToObject{1.0f};
    bool identity = false;
    bool mirrored = false;
};

/// The placement of an instance. A transform that flattens space is given a thousandth of
/// thickness, so that rays can be taken back through it; nothing where it leaves no area or is not
/// finite.
[[nodiscard]] std::optional<Placement> placementOf(const glm::mat4& objectToWorld);

/// A position as the device has it: one texel, the fourth component 0.
using DevicePosition = glm::vec4;
[[nodiscard]] std::vector<DevicePosition> packPositions(std::span<const glm::vec3> positions);

/// Where a mesh's attributes stand in the streams; counted in elements.
struct MeshRange {
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    uint32_t firstVertex = 0;
    uint32_t firstTangent = shared::SCENE_NONE;
    uint32_t firstTexcoord = shared::SCENE_NONE;
    uint32_t firstColour = shared::SCENE_NONE;
};

/// Layers of the two texture arrays by the snapshot's image index; SCENE_NONE where an image is not
/// used so.
struct TextureLayers {
    std::vector<uint32_t> colour;
    std::vector<uint32_t> data;
};

/// INSTANCE_… of an instance with that material and placement.
[[nodiscard]] uint32_t instanceFlags(const assets::Material& material, const Placement& placement);

/// Instances without a placement get zero rows: they are drawn as nothing.
[[nodiscard]] shared::GpuInstance packInstance(const scene::SnapshotInstance& instance,
                                               const assets::Material& material,
                                               const MeshRange& range);
[[nodiscard]] shared::GpuMaterial packMaterial(const assets::Material& material,
                                               const TextureLayers& layers);
[[nodiscard]] shared::GpuLight packLight(const scene::SnapshotLight& light);

}  // namespace lampyris::residency
