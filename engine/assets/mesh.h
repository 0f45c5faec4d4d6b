/// \file CPU geometry: one material a mesh (a glTF primitive), triangles only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "math/bounds.h"
#include "math/glm.h"

namespace lampyris::assets {

/// Offsets added to a mesh's vertices, weighted; empty vectors where the target does not move them.
struct MorphTarget {
    std::vector<glm::vec3> positions;  ///< metres, object space
    std::vector<glm::vec3> normals;
};

/// An indexed triangle mesh in object space. Optional attributes are empty, or as long as
/// positions.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;   ///< metres; always finite
    std::vector<glm::vec3> normals;     ///< unit; always there
    std::vector<glm::vec4> tangents;    ///< unit, w = handedness; optional
    std::vector<glm::vec2> texcoords0;  ///< optional
    std::vector<glm::vec2> texcoords1;  ///< optional; kept for light maps
    std::vector<glm::vec4> colours;     ///< linear RGBA, multiplies the base colour; optional
    std::vector<glm::uvec4> joints;     ///< optional
    std::vector<glm::vec4> weights;     ///< optional, summing to 1
    std::vector<MorphTarget> morphTargets;
    std::vector<float> morphWeights;  ///< default weights, as many as targets
    std::vector<uint32_t> indices;    ///< three a triangle, each < positions.size()
    math::Bounds bounds;

    [[nodiscard]] uint32_t triangleCount() const {
        return static_cast<uint32_t>(indices.size() / 3);
    }
};

/// Recomputes bounds from the positions that the indices use.
void updateBounds(Mesh& mesh);

}  // namespace lampyris::assets
