#include "courtyard/courtyard.h"

#include <utility>

#include "courtyard/building.h"
#include "courtyard/figure.h"
#include "courtyard/movements.h"
#include "courtyard/moving_things.h"
#include "courtyard/player.h"
#include "courtyard/visitors.h"
#include "scene/motion.h"

namespace lampyris::courtyard {
namespace {

void spawnCameras(ecs::World& world) {
    scene::spawnCamera(world, "square", {6.3f, 2.7f, 5.4f}, {-2.5f, 1.3f, -2.6f},
                       {.verticalFovRadians = math::kPi * 49.0f / 180.0f});
    scene::spawnCamera(world, "workshop", {-7.9f, 1.9f, 2.9f}, {-11.0f, 1.25f, -1.4f},
                       {.verticalFovRadians = math::kPi / 3.0f});
    scene::spawnCamera(world, "arcade", {6.3f, 1.7f, -7.0f}, {-4.0f, 1.35f, -7.6f},
                       {.verticalFovRadians = math::kPi / 3.0f});
}

}  // namespace

ecs::World makeCourtyard(uint32_t seed) {
    ecs::World world = scene::newWorld();
    auto& library = world.resource<scene::Library>();
    const Paints paints = makePaints(library);
    world.setResource(makeFigures(library));
    world.setResource(makeStock(library, paints, seed));
    spawnBuilding(world, paints);
    spawnPaving(world, paints);
    spawnRoofs(world, paints);
    spawnFurnishing(world, paints);
    spawnWorkshop(world, paints);
    spawnFountain(world, paints);
    spawnMill(world, paints);
    spawnDoor(world, paints);
    spawnBellows(world, paints);
    spawnBanners(world, paints);
    spawnCart(world, paints);
    spawnLanterns(world, paints);
    spawnWalkers(world, paints);
    spawnPlayer(world, paints);
    spawnCameras(world);
    scene::Motion motion;
    addVisiting(motion.systems);
    addMovements(motion.systems);
    world.setResource(std::move(motion));
    scene::advanceTo(world, 0.0, 0);
    return world;
}

}  // namespace lampyris::courtyard
