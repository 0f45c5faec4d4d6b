#include "residency/draw_list.h"

#include <algorithm>

namespace lampyris::residency {
namespace {

uint64_t offset(uint32_t first, MeshStreams::Stream stream) {
    return first == shared::SCENE_NONE ? 0 : first * MeshStreams::elementBytes(stream);
}

DrawItem itemOf(const scene::SnapshotInstance& instance, const MeshRange& range) {
    using Streams = MeshStreams;
    DrawItem item;
    item.material = instance.material;
    item.indexCount = range.indexCount;
    item.indexOffsetBytes = offset(range.firstIndex, Streams::Indices);
    item.positionOffsetBytes = offset(range.firstVertex, Streams::Positions);
    item.normalOffsetBytes = offset(range.firstVertex, Streams::Normals);
    item.tangentOffsetBytes = offset(range.firstTangent, Streams::Tangents);
    item.texcoordOffsetBytes = offset(range.firstTexcoord, Streams::Texcoords);
    item.colourOffsetBytes = offset(range.firstColour, Streams::Colours);
    item.hasTangents = range.firstTangent != shared::SCENE_NONE;
    item.hasTexcoords = range.firstTexcoord != shared::SCENE_NONE;
    item.hasColours = range.firstColour != shared::SCENE_NONE;
    item.posed = instance.pose != nullptr;
    return item;
}

}  // namespace

void DrawList::compare(DrawItem& item, const scene::SnapshotInstance& instance,
                       const PosedInstances& posed) const {
    item.objectToWorldBefore = instance.objectToWorld;
    const auto before = places_.find(instance.entity.bits);
    if (before == places_.end()) return;
    const uint32_t firstBefore = posed.firstBefore(instance);
    const bool reposed = firstBefore != shared::SCENE_NONE;
    if (!reposed && before->second == instance.objectToWorld) return;
    // As it was drawn. What cannot be drawn, now or then, has not moved.
    const auto placement = placementOf(before->second);
    if (!placement || !placementOf(instance.objectToWorld)) return;
    item.moved = true;
    item.objectToWorldBefore = placement->objectToWorld;
    item.reposed = reposed;
    if (reposed) item.positionBeforeOffsetBytes = offset(firstBefore, MeshStreams::Positions);
}

void DrawList::follow(const scene::SceneSnapshot& snapshot, const MeshStreams& meshes,
                      const PosedInstances& posed) {
    items_.clear();
    anyMoved_ = false;
    std::unordered_map<uint64_t, glm::mat4> places;
    places.reserve(snapshot.instances.size());
    for (uint32_t i = 0; i < snapshot.instances.size(); ++i) {
        const auto& instance = snapshot.instances[i];
        places.emplace(instance.entity.bits, instance.objectToWorld);
        const MeshRange& mesh = meshes.range(snapshot.meshes[instance.mesh].version);
        if (mesh.indexCount == 0) continue;
        DrawItem item = itemOf(instance, posed.rangeOf(instance, mesh));
        item.instance = i;
        item.textured = snapshot.materials[instance.material].value->textured();
        compare(item, instance, posed);
        anyMoved_ = anyMoved_ || item.moved;
        items_.push_back(item);
    }
    places_ = std::move(places);
}

void DrawList::settle(const scene::SceneSnapshot& snapshot) {
    if (!anyMoved_) return;
    anyMoved_ = false;
    for (DrawItem& item : items_) {
        if (!item.moved) continue;
        item.moved = item.reposed = false;
        item.positionBeforeOffsetBytes = 0;
        item.objectToWorldBefore = snapshot.instances[item.instance].objectToWorld;
    }
}

}  // namespace lampyris::residency
