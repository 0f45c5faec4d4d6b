/// \file Where an instance with Skin or MorphWeights stands, its pose, and what moves it.
#pragma once

#include <memory>

#include "ecs/world.h"
#include "scene/pose.h"

namespace lampyris::scene {

struct PlacedPose {
    std::shared_ptr<const Pose> pose;  ///< null where nothing deforms the mesh
    glm::mat4 objectToWorld{1.0f};
};

/// Reads Skin, MorphWeights, Transform, WorldTransform and the hierarchy. `extents` are the mesh's
/// (null: it cannot be deformed); a Skin on a mesh without joints is none.
/// A skinned instance's object space is that of the nearest entity at or above all its joints, not
/// its own, which plays no part [glTF 2.0, 3.7.3.3]: what moves there changes objectToWorld alone,
/// and no matrix need be inverted. A joint that is gone or missing counts as that space itself; if
/// all are gone, the instance's own space is.
[[nodiscard]] PlacedPose placeDeformed(const ecs::World& world, ecs::Entity entity,
                                       const PoseExtents* extents);

/// What is to be moved or deleted so that all of what an instance belongs to is: for a Skin the
/// nearest entity at or above it and its joints (without one, above its joints alone), for a
/// MeshPart its parent, otherwise itself.
[[nodiscard]] ecs::Entity wholeOf(const ecs::World& world, ecs::Entity shown);

}  // namespace lampyris::scene
