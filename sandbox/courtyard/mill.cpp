// What turns and blows at the workshop: a wheel on the west wall, the door, the bellows.
#include <array>

#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/movements.h"
#include "courtyard/moving_things.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

using scene::builtin::sinCosTurns;

constexpr glm::vec3 kHub{-6.45f, 1.75f, 4.3f};
constexpr float kWheelRadiusMetres = 1.45f;

/// Turns about x: two rims, spokes, paddles between the rims.
void addWheel(assets::Mesh& mesh) {
    const glm::mat4 upright = glm::mat4_cast(turned({0.0f, 0.0f, 1.0f}, 0.25));
    for (const float side : {-0.28f, 0.28f}) {
        const glm::mat4 rim = glm::translate(glm::mat4(1.0f), {side, 0.0f, 0.0f}) * upright;
        scene::builtin::addTorus(mesh, rim, kWheelRadiusMetres - 0.12f, 0.05f, 72, 10);
        scene::builtin::addTorus(mesh, rim, 0.22f, 0.05f, 32, 10);
    }
    for (int i = 0; i < 12; ++i) {
        const glm::mat4 turn = glm::mat4_cast(turned({1.0f, 0.0f, 0.0f}, i / 12.0));
        const auto box = [&](const glm::vec3& centre, const glm::vec3& half) {
            scene::builtin::addRoundedBox(mesh, glm::translate(turn, centre), {half, 0.015f, 1, 1});
        };
        box({0.0f, kWheelRadiusMetres - 0.14f, 0.0f}, {0.3f, 0.17f, 0.022f});
        for (const float side : {-0.28f, 0.28f})
            box({side, 0.5f * kWheelRadiusMetres, 0.0f}, {0.03f, 0.55f, 0.035f});
    }
}

/// A leaf of planks from the hinge along −z.
void addLeaf(assets::Mesh& mesh, const glm::vec3& size) {
    constexpr int kPlanks = 5;
    for (int i = 0; i < kPlanks; ++i) {
        const float z = -size.z * static_cast<float>(i) / kPlanks;
        const float next = -size.z * static_cast<float>(i + 1) / kPlanks;
        addBlock(mesh, {-0.5f * size.x, 0.0f, next}, {0.5f * size.x, size.y, z}, 0.012f);
    }
    for (const float y : {0.35f, 1.1f, 1.85f})
        addBlock(mesh, {-0.5f * size.x - 0.03f, y, 0.05f - size.z},
                 {0.5f * size.x + 0.03f, y + 0.14f, -0.05f});
}

/// An egg of leather; target 0 blows it up, target 1 draws it long.
void addBellows(assets::Mesh& mesh) {
    scene::builtin::addSphere(mesh, glm::vec3(0.0f), 0.34f, 16);
    mesh.morphTargets.resize(2);
    for (const glm::vec3& at : mesh.positions) {
        const float fold = static_cast<float>(sinCosTurns(5.0 * at.x / 0.68).cos);
        mesh.morphTargets[0].positions.push_back((0.22f + 0.12f * fold) *
                                                 glm::vec3(0.0f, at.y, at.z));
        mesh.morphTargets[1].positions.push_back(glm::vec3(0.25f * at.x, -0.15f * at.y, 0.0f));
    }
    mesh.morphWeights.assign(2, 0.0f);
}

}  // namespace

void spawnMill(ecs::World& world, const Paints& paints) {
    const ecs::Entity wheel = show(world, "mill wheel", paints.wood, addWheel, {kHub});
    world.add(wheel, Spin{{1.0f, 0.0f, 0.0f}, 0.06f});
    show(world, "axle", paints.iron, [](assets::Mesh& mesh) {
        addBar(mesh, kHub - glm::vec3(0.6f, 0.0f, 0.0f), kHub + glm::vec3(0.5f, 0.0f, 0.0f), 0.07f,
               20);
    });
}

void spawnDoor(ecs::World& world, const Paints& paints) {
    constexpr float kGap = 0.012f;
    const glm::vec3 size(0.07f, kDoorway.upper.y - 2.0f * kGap,
                         kDoorway.upper.z - kDoorway.lower.z - 2.0f * kGap);
    // The hinge stands at the south jamb on the square's face, so that the leaf swings outwards.
    const glm::vec3 hinge(kDoorway.upper.x - 0.06f, kGap + 0.02f, kDoorway.upper.z - kGap);
    const ecs::Entity leaf = show(world, "door", paints.green,
                                  [&](assets::Mesh& mesh) { addLeaf(mesh, size); }, {hinge});
    world.add(leaf, Door{-0.29f, 12.0f});
}

void spawnBellows(ecs::World& world, const Paints& paints) {
    const ecs::Entity bellows = show(world, "bellows", paints.crimson, addBellows,
                                     {kHearth + glm::vec3(0.1f, 1.05f, -1.25f)});
    world.add(bellows, scene::MorphWeights{{0.0f, 0.0f}});
    world.add(bellows, Ripple{4.0f, 1.0f});
}

}  // namespace lampyris::courtyard
