#include "residency/pack_scene.h"

#include <algorithm>
#include <array>

namespace lampyris::residency {
namespace {

// How thick a flattened instance becomes, as a share of its other extents: thinner loses the rays'
// precision, thicker is seen. [chosen]
constexpr float kFlatThickness = 1e-3f;
// Below this share of the largest possible, a determinant counts as zero. [chosen]
constexpr float kSingular = 1e-9f;

glm::vec4 row(const glm::mat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

bool finite(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int i = 0; i < 4; ++i)
            if (!std::isfinite(m[column][i])) return false;
    return true;
}

/// The product of the columns' lengths, which |det| reaches where they are perpendicular.
float volumeBound(const glm::mat3& m) {
    const float longest = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
    return longest * longest * longest;
}

/// Moves the column that lies in the plane of the other two out of it.
bool thicken(glm::mat3& m) {
    const std::array<float, 3> areas = {glm::length(glm::cross(m[1], m[2])),
                                        glm::length(glm::cross(m[2], m[0])),
                                        glm::length(glm::cross(m[0], m[1]))};
    const int flat = static_cast<int>(std::max_element(areas.begin(), areas.end()) - areas.begin());
    if (!(areas[flat] > 0.0f)) return false;
    const glm::vec3 out = glm::cross(m[(flat + 1) % 3], m[(flat + 2) % 3]) / areas[flat];
    const float side = glm::dot(out, m[flat]) < 0.0f ? -1.0f : 1.0f;
    m[flat] += out * (side * kFlatThickness * std::sqrt(areas[flat]));
    return true;
}

uint32_t packTexture(const assets::TextureUse& use, const std::vector<uint32_t>& layers) {
    if (!use.present()) return shared::SCENE_NONE;
    const uint32_t layer = layers[static_cast<size_t>(use.image)];
    if (layer == shared::SCENE_NONE) return layer;
    uint32_t bits = layer;
    if (use.wrapU == assets::Wrap::Clamp) bits |= shared::TEXTURE_CLAMP_U;
    if (use.wrapU == assets::Wrap::Mirror) bits |= shared::TEXTURE_MIRROR_U;
    if (use.wrapV == assets::Wrap::Clamp) bits |= shared::TEXTURE_CLAMP_V;
    if (use.wrapV == assets::Wrap::Mirror) bits |= shared::TEXTURE_MIRROR_V;
    if (use.filter == assets::Filter::Nearest) bits |= shared::TEXTURE_NEAREST;
    if (use.texcoordSet == 1) bits |= shared::TEXTURE_SECOND_SET;
    return bits;
}

bool emissive(const assets::Material& material) {
    return glm::any(glm::greaterThan(material.emissiveRadiance, glm::vec3(0.0f)));
}

}  // namespace

std::vector<DevicePosition> packPositions(std::span<const glm::vec3> positions) {
    std::vector<DevicePosition> packed;
    packed.reserve(positions.size());
    for (const glm::vec3& position : positions) packed.emplace_back(position, 0.0f);
    return packed;
}

std::optional<Placement> placementOf(const glm::mat4& objectToWorld) {
    if (!finite(objectToWorld)) return std::nullopt;
    Placement placement;
    placement.identity = objectToWorld == glm::mat4(1.0f);
    glm::mat3 linear(objectToWorld);
    if (std::abs(glm::determinant(linear)) <= kSingular * volumeBound(linear) && !thicken(linear))
        return std::nullopt;
    placement.objectToWorld = glm::mat4(linear);
    placement.objectToWorld[3] = objectToWorld[3];
    // In double: the inverse is used on coordinates far from the origin.
    placement.worldToObject = glm::mat4(glm::inverse(glm::dmat4(placement.objectToWorld)));
    placement.mirrored = glm::determinant(linear) < 0.0f;
    if (!finite(placement.worldToObject)) return std::nullopt;
    return placement;
}

uint32_t instanceFlags(const assets::Material& material, const Placement& placement) {
    uint32_t flags = 0;
    if (material.alphaMode == assets::AlphaMode::Mask) flags |= shared::INSTANCE_MASKED;
    if (emissive(material)) flags |= shared::INSTANCE_EMISSIVE;
    if (material.doubleSided) flags |= shared::INSTANCE_DOUBLE_SIDED;
    if (placement.identity) flags |= shared::INSTANCE_IDENTITY;
    if (placement.mirrored) flags |= shared::INSTANCE_MIRRORED;
    return flags;
}

shared::GpuInstance packInstance(const scene::SnapshotInstance& instance,
                                 const assets::Material& material, const MeshRange& range) {
    const auto found = placementOf(instance.objectToWorld);
    const Placement placement =
        found.value_or(Placement{glm::mat4(0.0f), glm::mat4(0.0f), false, false});
    shared::GpuInstance packed{};
    packed.objectToWorld0 = row(placement.objectToWorld, 0);
    packed.objectToWorld1 = row(placement.objectToWorld, 1);
    packed.objectToWorld2 = row(placement.objectToWorld, 2);
    packed.worldToObject0 = row(placement.worldToObject, 0);
    packed.worldToObject1 = row(placement.worldToObject, 1);
    packed.worldToObject2 = row(placement.worldToObject, 2);
    packed.material = instance.material;
    packed.flags = instanceFlags(material, placement);
    packed.firstIndex = range.firstIndex;
    packed.firstVertex = range.firstVertex;
    packed.firstTexcoord = range.firstTexcoord;
    packed.firstColour = range.firstColour;
    packed.firstTangent = range.firstTangent;
    packed.entity = instance.entity.bits;
    return packed;
}

shared::GpuMaterial packMaterial(const assets::Material& material, const TextureLayers& layers) {
    shared::GpuMaterial packed{};
    packed.baseColour = material.baseColour;
    packed.emissiveRadiance = glm::vec4(material.emissiveRadiance, 0.0f);
    packed.specular = glm::vec4(material.specularColour, material.specularFactor);
    packed.metallic = material.metallic;
    packed.roughness = material.roughness;
    packed.normalScale = material.normalScale;
    packed.alphaCutoff = material.alphaCutoff;
    packed.baseColourTexture = packTexture(material.baseColourTexture, layers.colour);
    packed.metallicRoughnessTexture = packTexture(material.metallicRoughnessTexture, layers.data);
    packed.emissiveTexture = packTexture(material.emissiveTexture, layers.colour);
    packed.normalTexture = packTexture(material.normalTexture, layers.data);
    if (material.alphaMode == assets::AlphaMode::Mask) packed.flags |= shared::MATERIAL_MASKED;
    if (material.doubleSided) packed.flags |= shared::MATERIAL_DOUBLE_SIDED;
    if (emissive(material)) packed.flags |= shared::MATERIAL_EMISSIVE;
    return packed;
}

shared::GpuLight packLight(const scene::SnapshotLight& light) {
    return {glm::vec4(light.positionWorld, light.radiusMetres),
            glm::vec4(light.powerWatts, light.cosOuterCone),
            glm::vec4(light.directionWorld, light.cosInnerCone)};
}

}  // namespace lampyris::residency
