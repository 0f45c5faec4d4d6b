/// \file Shapes that the built-in scenes' own (scene/builtin/shapes.h) do not have.
#pragma once

#include <span>

#include "assets/mesh.h"
#include "math/glm.h"

namespace lampyris::courtyard {

/// The rotation by `turns` about a unit axis.
[[nodiscard]] glm::quat turned(const glm::vec3& axis, double turns);

/// A surface of revolution about the placement's y axis: (radius, height) from the bottom upwards
/// on the outside. A point given twice is a crease. 2 · sides a step.
void addLathe(assets::Mesh& mesh, const glm::mat4& placement, std::span<const glm::vec2> profile,
              uint32_t sides);

/// A box with slightly rounded edges between two corners: 108 triangles.
void addBlock(assets::Mesh& mesh, const glm::vec3& lower, const glm::vec3& upper,
              float edgeRadius = 0.015f);

/// What makes an arch of an opening: fills its upper corners, `depth` thick around the placement's
/// x-y plane; the opening is `width` wide around x = 0, its top at `topY`.
struct ArchForm {
    float width = 2.0f;
    float topY = 2.9f;
    float depth = 0.4f;
};
void addArch(assets::Mesh& mesh, const glm::mat4& placement, const ArchForm& form);

/// A bar of round section between two points.
void addBar(assets::Mesh& mesh, const glm::vec3& a, const glm::vec3& b, float radius,
            uint32_t sides = 8);

/// Joins the grid of vertices that begins at `first`: rows of `columns` vertices, the last column
/// joined to the first where it wraps.
void addGrid(assets::Mesh& mesh, uint32_t first, uint32_t columns, uint32_t rows, bool wraps);

/// Normals of the vertices from `first` on, from the triangles around them.
void smoothNormals(assets::Mesh& mesh, uint32_t first);

}  // namespace lampyris::courtyard
