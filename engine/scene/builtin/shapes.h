/// \file Triangles for the built-in scenes. Every shape is appended to a mesh, its outside
/// counter-clockwise, its normals outward.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assets/mesh.h"
#include "math/glm.h"

namespace lampyris::scene::builtin {

/// A rotation about y followed by a translation.
[[nodiscard]] glm::mat4 placed(const glm::vec3& translation, double yawDegrees = 0.0);

/// Two triangles a b c, a c d with a flat normal; counter-clockwise as seen from the front.
void addQuad(assets::Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
             const glm::vec3& d);

/// A box of six quads, centred at the placement's origin. `placement` is rigid.
void addBox(assets::Mesh& mesh, const glm::mat4& placement, const glm::vec3& halfExtent);

/// A box around the origin as a mesh of its own.
[[nodiscard]] assets::Mesh boxMesh(const glm::vec3& halfExtent);

/// A box with rounded edges; a sphere where all half extents are `edgeRadius`.
/// Has 12 (2 · cornerSteps + flatSteps)² triangles; without flat steps the box must be a sphere.
struct RoundedBox {
    glm::vec3 halfExtent{0.5f};  ///< metres, edges included
    float edgeRadius = 0.1f;     ///< metres
    uint32_t cornerSteps = 3;    ///< an eighth of a turn is cut into so many
    uint32_t flatSteps = 1;
};
void addRoundedBox(assets::Mesh& mesh, const glm::mat4& placement, const RoundedBox& box);

/// 12 · steps² triangles, without poles. `steps` is even.
void addSphere(assets::Mesh& mesh, const glm::vec3& centre, float radius, uint32_t steps);

/// A closed cylinder about the y axis from the placement's origin upwards: 4 · sides − 4 triangles.
void addCylinder(assets::Mesh& mesh, const glm::mat4& placement, float radius, float height,
                 uint32_t sides);

/// A ring in the placement's x-z plane: 2 · around · across triangles.
void addTorus(assets::Mesh& mesh, const glm::mat4& placement, float radius, float tubeRadius,
              uint32_t around, uint32_t across);

/// An open tube along a path: 2 · sides · (points − 1) triangles. No two neighbours may coincide.
void addTube(assets::Mesh& mesh, std::span<const glm::vec3> path, float radius, uint32_t sides);

}  // namespace lampyris::scene::builtin
