#include "residency/rest_meshes.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/check.h"
#include "shared/pose.h"

namespace lampyris::residency {
namespace {

constexpr uint64_t kRestBytes = shared::REST_TEXELS * sizeof(glm::uvec4);
constexpr uint64_t kDeltaBytes = shared::DELTA_TEXELS * sizeof(glm::vec4);

using RestVertex = std::array<glm::uvec4, shared::REST_TEXELS>;
using Delta = std::array<glm::vec4, shared::DELTA_TEXELS>;

glm::uvec4 bits(const glm::vec4& v) {
    return {std::bit_cast<uint32_t>(v.x), std::bit_cast<uint32_t>(v.y),
            std::bit_cast<uint32_t>(v.z), std::bit_cast<uint32_t>(v.w)};
}

std::vector<RestVertex> packVertices(const assets::Mesh& mesh) {
    std::vector<RestVertex> packed(mesh.positions.size());
    for (size_t i = 0; i < packed.size(); ++i) {
        const glm::uvec4 joints = mesh.joints.empty() ? glm::uvec4(0) : mesh.joints[i];
        packed[i] = {bits(glm::vec4(mesh.positions[i], 0.0f)),
                     bits(glm::vec4(mesh.normals[i], 0.0f)),
                     bits(mesh.weights.empty() ? glm::vec4(0.0f) : mesh.weights[i]),
                     bits(mesh.tangents.empty() ? glm::vec4(0.0f) : mesh.tangents[i])};
        packed[i][0].w = joints.x | joints.y << 16;
        packed[i][1].w = joints.z | joints.w << 16;
    }
    return packed;
}

std::vector<Delta> packDeltas(const assets::MorphTarget& target, size_t vertices) {
    std::vector<Delta> packed(vertices, Delta{glm::vec4(0.0f), glm::vec4(0.0f)});
    for (size_t i = 0; i < target.positions.size(); ++i)
        packed[i][0] = glm::vec4(target.positions[i], 0.0f);
    for (size_t i = 0; i < target.normals.size(); ++i)
        packed[i][1] = glm::vec4(target.normals[i], 0.0f);
    return packed;
}

}  // namespace

RestMeshes::RestMeshes(Device& device)
    : device_(&device),
      vertices_(device, "rest vertices", sizeof(glm::uvec4)),
      deltas_(device, "morph deltas", sizeof(glm::vec4)) {}

RestRange RestMeshes::range(uint64_t meshVersion) const {
    const auto entry = entries_.find(meshVersion);
    CHECK(entry != entries_.end());
    return entry->second.range;
}

void RestMeshes::forgetMissing(const Wanted& wanted) {
    std::erase_if(entries_, [&](const auto& item) {
        const auto& [version, entry] = item;
        if (wanted.contains(version)) return false;
        vertexRanges_.give(entry.range.firstRest, entry.vertexCount);
        deltaRanges_.give(entry.range.firstDelta, entry.deltaCount);
        return true;
    });
}

core::Result<uint64_t> RestMeshes::write(Loading& loading, const assets::Mesh& mesh,
                                         const Entry& entry) {
    const auto packed = packVertices(mesh);
    TRY_VOID(loading.write(vertices_, entry.range.firstRest * kRestBytes,
                           std::as_bytes(std::span(packed))));
    uint64_t first = entry.range.firstDelta;
    for (const assets::MorphTarget& target : mesh.morphTargets) {
        const auto deltas = packDeltas(target, mesh.positions.size());
        TRY_VOID(loading.write(deltas_, first * kDeltaBytes, std::as_bytes(std::span(deltas))));
        first += deltas.size();
    }
    return entry.vertexCount * kRestBytes + entry.deltaCount * kDeltaBytes;
}

core::Result<uint64_t> RestMeshes::follow(const scene::SceneSnapshot& snapshot) {
    Wanted wanted;
    for (const auto& instance : snapshot.instances)
        if (instance.pose)
            wanted.emplace(snapshot.meshes[instance.mesh].version,
                           snapshot.meshes[instance.mesh].value.get());
    forgetMissing(wanted);
    std::vector<uint64_t> added;
    for (const auto& [version, mesh] : wanted) {
        const auto [entry, isNew] = entries_.try_emplace(version);
        if (!isNew) continue;
        const uint64_t vertices = mesh->positions.size();
        const uint64_t deltas = vertices * mesh->morphTargets.size();
        entry->second = {{static_cast<uint32_t>(vertexRanges_.take(vertices)),
                          static_cast<uint32_t>(deltaRanges_.take(deltas))},
                         vertices,
                         deltas};
        added.push_back(version);
    }
    if (added.empty()) return uint64_t{0};
    TRY_VOID(vertices_.reserve(vertexRanges_.capacity() * kRestBytes));
    TRY_VOID(deltas_.reserve(std::max<uint64_t>(deltaRanges_.capacity(), 1) * kDeltaBytes));
    TRY(Loading loading, Loading::begin(*device_));
    uint64_t sum = 0;
    for (const uint64_t version : added) {
        TRY(const uint64_t bytes, write(loading, *wanted[version], entries_[version]));
        sum += bytes;
    }
    TRY_VOID(loading.finish());
    return sum;
}

}  // namespace lampyris::residency
