/// \file A walking figure: a skinned mesh on thirteen joints, and the clip of its stride.
#pragma once

#include <memory>

#include "courtyard/paints.h"
#include "courtyard/route.h"

namespace lampyris::courtyard {

/// The joints, parents before children. Left is +x; the figure looks along +z.
enum Joint : uint32_t {
    kHips,
    kChest,
    kHead,
    kLeftArm,
    kLeftForearm,
    kRightArm,
    kRightForearm,
    kLeftThigh,
    kLeftShin,
    kLeftFoot,
    kRightThigh,
    kRightShin,
    kRightFoot,
    kJointCount
};

struct JointRest {
    Joint parent;              ///< itself for the root
    glm::vec3 positionMetres;  ///< of the figure at rest, feet at y = 0
};
[[nodiscard]] JointRest restOf(Joint joint);

/// Robe, limbs and head as tubes whose weights blend at the joints: about 8 thousand triangles.
[[nodiscard]] assets::Mesh makeFigureMesh();

/// What all figures share; a resource of the world.
struct Figures {
    scene::MeshId mesh;
    scene::ClipId stride;
};
constexpr float kStrideSeconds = 1.2f;
constexpr float kWalkMetresPerSecond = 1.15f;  ///< at which the feet do not slide

[[nodiscard]] Figures makeFigures(scene::Library& library);

/// A figure and its joints below one entity, which is returned; it strides from
/// `startSeconds` on. Destroying it takes all with it.
ecs::Entity spawnFigure(ecs::World& world, const Figures& figures, scene::MaterialId paint,
                        const scene::Transform& place, double startSeconds);

/// Those that live here: one goes round the fountain, one through the arcade.
void spawnWalkers(ecs::World& world, const Paints& paints);

}  // namespace lampyris::courtyard
