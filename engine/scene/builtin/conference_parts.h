/// \file The furniture of `conference`, each part appended to the mesh of its material.
#pragma once

#include "assets/mesh.h"
#include "math/glm.h"

namespace lampyris::scene::builtin {

/// Seat and back of a swivel chair that faces the placement's +z; its foot is the origin.
void addChairCushions(assets::Mesh& mesh, const glm::mat4& placement);
/// Its post, star, castors and arm rests.
void addChairFrame(assets::Mesh& mesh, const glm::mat4& placement);
/// A cup with a handle that stands on the placement's origin.
void addCup(assets::Mesh& mesh, const glm::mat4& placement);
/// A hanging ring around a lamp, with three cables up to `ceilingY`.
void addLampRing(assets::Mesh& mesh, const glm::vec3& centre, float ceilingY);
/// Slats in front of a window, `size` wide and high, from the placement's origin down, along x.
void addBlind(assets::Mesh& mesh, const glm::vec3& topLeft, const glm::vec2& size);
/// A folded curtain that hangs from `top` along x, `size` wide and high.
void addCurtain(assets::Mesh& mesh, const glm::vec3& top, const glm::vec2& size);
/// A tuft of bent leaves that grows from `foot`.
void addLeaves(assets::Mesh& mesh, const glm::vec3& foot, uint32_t seed);

}  // namespace lampyris::scene::builtin
