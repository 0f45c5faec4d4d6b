/// \file morph, skin: the vertices of instances whose pose changed.
///   in      rest vertices, morph deltas, poses      out   their ranges of positions, normals,
///   tangents, positionsBefore    shader  residency/morph.comp, residency/skin.comp
#pragma once

#include <vector>

#include "residency/scene_handles.h"
#include "shared/pose.h"

namespace lampyris::residency {

/// One dispatch's work: an instance each.
class PoseJobs {
 public:
    void clear() { *this = {}; }
    void add(shared::PoseJob job);
    [[nodiscard]] bool empty() const { return jobs_.empty(); }
    [[nodiscard]] uint32_t vertexCount() const { return vertexCount_; }
    [[nodiscard]] const std::vector<shared::PoseJob>& jobs() const { return jobs_; }

 private:
    std::vector<shared::PoseJob> jobs_;
    uint32_t vertexCount_ = 0;
};

struct PoseSources {
    graph::Buffer restVertices;
    graph::Buffer morphDeltas;
    graph::Buffer poses;
};

/// Declares a node for each list that has jobs, and hands on what they write in `handles`.
void addPoseNodes(graph::Frame& frame, const PoseJobs& morphs, const PoseJobs& skins,
                  const PoseSources& sources, SceneHandles& handles);

}  // namespace lampyris::residency
