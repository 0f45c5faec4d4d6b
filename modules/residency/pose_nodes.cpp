#include "residency/pose_nodes.h"

#include <algorithm>

#include "residency/shaders.h"

namespace lampyris::residency {
namespace {

using graph::Format;

/// What both nodes bind, and the dispatch.
void pose(graph::ComputeNode node, const PoseJobs& jobs, const PoseSources& sources,
          SceneHandles& handles) {
    node.storageData(shared::SLOT_POSE_JOBS, jobs.jobs().data(),
                     jobs.jobs().size() * sizeof(shared::PoseJob))
        .texels(shared::SLOT_REST_VERTICES, sources.restVertices, Format::RGBA32Uint)
        .texels(shared::SLOT_POSES, sources.poses, Format::RGBA32Float)
        .push(shared::PoseParams{static_cast<uint32_t>(jobs.jobs().size()), jobs.vertexCount(), 0,
                                 0});
    handles.positions =
        node.updateTexels(shared::SLOT_POSED_POSITIONS, handles.positions, Format::RGBA32Float);
    handles.normals =
        node.updateTexels(shared::SLOT_POSED_NORMALS, handles.normals, Format::R32Float);
    handles.tangents =
        node.updateTexels(shared::SLOT_POSED_TANGENTS, handles.tangents, Format::RGBA32Float);
    handles.positionsBefore = node.updateTexels(shared::SLOT_POSED_POSITIONS_BEFORE,
                                                handles.positionsBefore, Format::RGBA32Float);
    const uint32_t groups = (jobs.vertexCount() + shared::POSE_THREADS - 1) / shared::POSE_THREADS;
    const uint32_t row = std::min(groups, shared::POSE_GROUPS_IN_ROW);
    node.dispatch(row, (groups + row - 1) / row);
}

}  // namespace

void PoseJobs::add(shared::PoseJob job) {
    if (job.vertexCount == 0) return;
    job.firstThread = vertexCount_;
    vertexCount_ += job.vertexCount;
    jobs_.push_back(job);
}

void addPoseNodes(graph::Frame& frame, const PoseJobs& morphs, const PoseJobs& skins,
                  const PoseSources& sources, SceneHandles& handles) {
    if (!morphs.empty()) {
        auto node = frame.compute("morph", shaders::morph);
        node.texels(shared::SLOT_MORPH_DELTAS, sources.morphDeltas, Format::RGBA32Float);
        pose(node, morphs, sources, handles);
    }
    if (!skins.empty()) pose(frame.compute("skin", shaders::skin), skins, sources, handles);
}

}  // namespace lampyris::residency
