/// \file How a deformed mesh stands: morph targets first, then joints.
#pragma once

#include <vector>

#include "assets/mesh.h"

namespace lampyris::scene {

/// What decides the posed vertices of one instance.
struct Pose {
    std::vector<float> morphWeights;       ///< as many as the mesh has targets
    std::vector<glm::mat4> jointMatrices;  ///< mesh space at rest to the instance's object space;
                                           ///< empty: no skin
    bool operator==(const Pose&) const = default;
};

/// Vertices in the instance's object space, as long as the mesh's own lists.
struct PosedVertices {
    std::vector<glm::vec3> positions;  ///< metres; may hold what is not finite where matrices do
    std::vector<glm::vec3> normals;    ///< unit
    std::vector<glm::vec4> tangents;   ///< unit, w = handedness; empty where the mesh has none
};

/// Evaluates the pose on the CPU [glTF 2.0, 3.7.2.2 and 3.7.3.3]: the twin of residency's morph and
/// skin nodes.
[[nodiscard]] PosedVertices posedVertices(const assets::Mesh& mesh, const Pose& pose);

/// What bounds of a posed mesh are made of; for meshes that have joints or morph targets.
struct PoseExtents {
    math::Bounds rest;                  ///< of all vertices
    std::vector<math::Bounds> joints;   ///< of the vertices at rest that follow each; up to the
                                        ///< highest joint of the mesh
    std::vector<math::Bounds> offsets;  ///< of each morph target; holds 0
};
[[nodiscard]] PoseExtents poseExtents(const assets::Mesh& mesh);

/// A box that holds the finite ones of the posed vertices, made from boxes alone: wider than they
/// need. Finite.
[[nodiscard]] math::Bounds posedBounds(const PoseExtents& extents, const Pose& pose);
[[nodiscard]] math::Bounds posedBounds(const assets::Mesh& mesh, const Pose& pose);

}  // namespace lampyris::scene
