#include "residency/posed_instances.h"

#include <algorithm>

#include "core/check.h"

namespace lampyris::residency {
namespace {

constexpr uint64_t kPositionBytes = sizeof(DevicePosition);

bool isSkinned(const assets::Mesh& mesh, const scene::Pose& pose) {
    return !pose.jointMatrices.empty() && !mesh.joints.empty();
}

bool isMorphed(const assets::Mesh& mesh, const scene::Pose& pose) {
    const size_t targets = std::min(mesh.morphTargets.size(), pose.morphWeights.size());
    return std::any_of(pose.morphWeights.begin(),
                       pose.morphWeights.begin() + static_cast<std::ptrdiff_t>(targets),
                       [](float weight) { return weight != 0.0f; });
}

/// Three rows a joint: what the last row holds is never used.
void packJoints(const scene::Pose& pose, std::vector<glm::vec4>& texels) {
    for (const glm::mat4& m : pose.jointMatrices)
        for (int row = 0; row < 3; ++row)
            texels.emplace_back(m[0][row], m[1][row], m[2][row], m[3][row]);
}

/// Only targets that count. \return how many
uint32_t packWeights(const assets::Mesh& mesh, const scene::Pose& pose,
                     std::vector<glm::vec4>& texels) {
    const size_t before = texels.size();
    const size_t targets = std::min(mesh.morphTargets.size(), pose.morphWeights.size());
    for (size_t t = 0; t < targets; ++t)
        if (pose.morphWeights[t] != 0.0f)
            texels.emplace_back(pose.morphWeights[t], static_cast<float>(t), 0.0f, 0.0f);
    return static_cast<uint32_t>(texels.size() - before);
}

}  // namespace

PosedInstances::PosedInstances(Device& device)
    : rest_(device),
      poses_(device, "poses", sizeof(glm::vec4)),
      before_(device, "positions before", sizeof(DevicePosition)) {}

void PosedInstances::place(const scene::SceneSnapshot& snapshot, MeshStreams& streams) {
    ++round_;
    // Ranges are given back before others are taken, so that the streams grow only when they must.
    std::vector<const scene::SnapshotInstance*> added;
    for (const auto& instance : snapshot.instances) {
        if (!instance.pose) continue;
        const auto entry = entries_.find(instance.entity.bits);
        if (entry != entries_.end() &&
            entry->second.meshVersion == snapshot.meshes[instance.mesh].version)
            entry->second.seen = round_;
        else
            added.push_back(&instance);
    }
    std::erase_if(entries_, [&](const auto& item) {
        if (item.second.seen == round_) return false;
        streams.givePosed(item.second.range);
        return true;
    });
    for (const auto* instance : added) {
        const auto& mesh = snapshot.meshes[instance->mesh];
        Entry entry;
        entry.range = streams.takePosed(*mesh.value);
        entry.meshVersion = mesh.version;
        entry.seen = round_;
        CHECK(entries_.emplace(instance->entity.bits, entry).second);
    }
}

void PosedInstances::addJobs(const assets::Mesh& mesh, const scene::Pose& pose, const Entry& entry,
                             std::vector<glm::vec4>& texels) {
    const RestRange rest = rest_.range(entry.meshVersion);
    shared::PoseJob job{};
    job.vertexCount = entry.range.vertexCount;
    job.firstVertex = entry.range.firstVertex;
    job.firstTangent = entry.range.firstTangent;
    job.firstBefore = entry.firstBefore;
    job.firstRest = rest.firstRest;
    job.firstDelta = rest.firstDelta;
    const bool skinned = isSkinned(mesh, pose);
    // What neither moves is put back to rest by the morph node.
    const bool morphed = !skinned || isMorphed(mesh, pose);
    job.flags = (morphed ? shared::POSE_MORPHED : 0u) | (skinned ? shared::POSE_SKINNED : 0u);
    if (morphed) {
        job.firstWeight = static_cast<uint32_t>(texels.size());
        job.weightCount = packWeights(mesh, pose, texels);
        morphs_.add(job);
    }
    if (skinned) {
        job.firstJoint = static_cast<uint32_t>(texels.size());
        job.jointCount = static_cast<uint32_t>(pose.jointMatrices.size());
        packJoints(pose, texels);
        skins_.add(job);
    }
}

core::Result<uint64_t> PosedInstances::load(const scene::SceneSnapshot& snapshot,
                                            const MeshStreams& streams) {
    TRY(const uint64_t restBytes, rest_.follow(snapshot));
    list_.clear();
    morphs_.clear();
    skins_.clear();
    std::vector<glm::vec4> texels;
    uint64_t moving = 0;
    for (uint32_t i = 0; i < snapshot.instances.size(); ++i) {
        const auto& instance = snapshot.instances[i];
        if (!instance.pose) continue;
        const auto& mesh = snapshot.meshes[instance.mesh];
        Entry& entry = entries_.at(instance.entity.bits);
        entry.moved = entry.placed && entry.poseVersion != instance.poseVersion;
        entry.pending = entry.pending || !entry.placed || entry.moved;
        entry.placed = true;
        entry.poseVersion = instance.poseVersion;
        list_.push_back({i, instance.entity, mesh.version, instance.poseVersion,
                         entry.range.firstVertex, streams.range(mesh.version).firstIndex});
        if (!entry.pending) continue;
        entry.firstBefore = static_cast<uint32_t>(moving);
        moving += entry.range.vertexCount;
        addJobs(*mesh.value, *instance.pose, entry, texels);
    }
    if (morphs_.empty() && skins_.empty()) return restBytes;
    const auto bytes = std::as_bytes(std::span(texels));
    TRY_VOID(poses_.reserve(std::max(bytes.size(), sizeof(glm::vec4))));
    TRY_VOID(before_.reserve(moving * kPositionBytes));
    TRY_VOID(poses_.stage(0, bytes));
    return restBytes + bytes.size();
}

void PosedInstances::settle() {
    for (auto& [entity, entry] : entries_) entry.moved = false;
}

void PosedInstances::import(graph::Frame& frame, SceneHandles& handles) {
    // Without anything that moved there is no before but now.
    handles.positionsBefore = handles.positions;
    if (before_.bytes() == 0) return;
    handles.positionsBefore = before_.import(frame, "upload positions before");
    if (morphs_.empty() && skins_.empty()) return;
    addPoseNodes(
        frame, morphs_, skins_,
        {rest_.vertices().import(frame, "upload rest vertices"),
         rest_.deltas().import(frame, "upload morph deltas"), poses_.import(frame, "upload poses")},
        handles);
    morphs_.clear();
    skins_.clear();
    for (auto& [entity, entry] : entries_) entry.pending = false;
}

MeshRange PosedInstances::rangeOf(const scene::SnapshotInstance& instance,
                                  const MeshRange& mesh) const {
    if (!instance.pose) return mesh;
    const PosedRange& own = entries_.at(instance.entity.bits).range;
    MeshRange range = mesh;
    range.firstVertex = own.firstVertex;
    range.firstTangent = own.firstTangent;
    return range;
}

uint32_t PosedInstances::firstBefore(const scene::SnapshotInstance& instance) const {
    if (!instance.pose) return shared::SCENE_NONE;
    const Entry& entry = entries_.at(instance.entity.bits);
    return entry.moved ? entry.firstBefore : shared::SCENE_NONE;
}

}  // namespace lampyris::residency
