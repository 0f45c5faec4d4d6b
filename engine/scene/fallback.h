/// \file What a file without a camera or a light gets.
#pragma once

#include <string>

#include "ecs/world.h"
#include "math/bounds.h"
#include "scene/components.h"

namespace lampyris::scene {

/// Where a camera of `camera.verticalFovRadians` stands to see all of the bounds.
struct Framing {
    Transform transform;
    Camera camera;  ///< 40°; the near plane is in proportion to the distance
};

/// From direction (1, 0.7, 1); every corner is in view in pictures at least as wide as high. Works
/// for empty and point-like bounds, and for sizes from 1e-12 to 1e17 m.
[[nodiscard]] Framing frame(const math::Bounds& bounds);

/// A light above the bounds, on the framing camera's side. A surface of albedo ½ in the bounds'
/// centre reads mid-grey (radiance 0.18) on average over the directions it may face.
struct LightAbove {
    glm::vec3 position;
    SphereLight light;
};
[[nodiscard]] LightAbove lightAbove(const math::Bounds& bounds);

/// Bounds of all that is drawn; world transforms must be up to date.
[[nodiscard]] math::Bounds boundsWorld(const ecs::World& world);

/// Adds the framing camera where the world has none, with one warning that names the scene.
void addMissingCamera(ecs::World& world, const std::string& scene);

/// Adds the light above where there is none and nothing drawn is emissive, with one warning. Lights
/// without power stay as they are, with a warning that everything is black.
void addMissingLight(ecs::World& world, const std::string& scene);

}  // namespace lampyris::scene
