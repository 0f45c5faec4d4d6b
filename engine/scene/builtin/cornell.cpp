// cornell, and the box that cornell_statue and cornell_hairball share with it.
#include <utility>

#include "scene/builtin/builtin.h"
#include "scene/builtin/hairball.h"
#include "scene/builtin/shapes.h"
#include "scene/builtin/statue.h"
#include "scene/spawn.h"

namespace lampyris::scene::builtin {

namespace {

constexpr glm::vec3 kLower(-5.0f, 0.0f, -5.0f);
constexpr glm::vec3 kUpper(5.0f, 10.0f, 5.0f);

/// Corner of the interior: each flag picks the upper side.
glm::vec3 corner(bool x, bool y, bool z) {
    return {x ? kUpper.x : kLower.x, y ? kUpper.y : kLower.y, z ? kUpper.z : kLower.z};
}

/// Floor, ceiling and back.
assets::Mesh greyWalls() {
    assets::Mesh mesh;
    mesh.name = "grey";
    addQuad(mesh, corner(false, false, true), corner(true, false, true), corner(true, false, false),
            corner(false, false, false));
    addQuad(mesh, corner(false, true, false), corner(true, true, false), corner(true, true, true),
            corner(false, true, true));
    addQuad(mesh, corner(false, false, false), corner(true, false, false),
            corner(true, true, false), corner(false, true, false));
    return mesh;
}

assets::Mesh sideWall(const char* name, bool right) {
    assets::Mesh mesh;
    mesh.name = name;
    addQuad(mesh, corner(right, false, !right), corner(right, false, right),
            corner(right, true, right), corner(right, true, !right));
    assets::updateBounds(mesh);
    return mesh;
}

/// Walls, light and camera. `grey` is floor, ceiling and back with what stands on it.
MaterialId fillBox(ecs::World& world, assets::Mesh grey) {
    auto& library = world.resource<Library>();
    const MaterialId greyPaint = library.addMaterial(lambertian("grey", glm::vec3(0.73f)));
    const MaterialId red = library.addMaterial(lambertian("red", {0.63f, 0.065f, 0.05f}));
    const MaterialId green = library.addMaterial(lambertian("green", {0.14f, 0.45f, 0.091f}));
    assets::updateBounds(grey);
    spawnMesh(world, std::move(grey), greyPaint);
    spawnMesh(world, sideWall("left wall", false), red);
    spawnMesh(world, sideWall("right wall", true), green);
    spawnLight(world, "light", {0.0f, 8.5f, 0.0f},
               {.radiusMetres = 0.4f, .powerWatts = glm::vec3(1000.0f)});
    spawnCamera(world, "camera", {0.13f, 5.07f, 19.0f}, {0.13f, 5.07f, 0.0f});
    return greyPaint;
}

}  // namespace

void fillCornell(ecs::World& world) {
    assets::Mesh grey = greyWalls();
    addBox(grey, placed({-1.7f, 3.0f, -1.4f}, 17.0), {1.5f, 3.0f, 1.5f});
    addBox(grey, placed({1.7f, 1.5f, 1.5f}, -17.0), {1.5f, 1.5f, 1.5f});
    fillBox(world, std::move(grey));
}

void fillCornellStatue(ecs::World& world) {
    constexpr float kPlinthHeight = 2.0f;
    assets::Mesh grey = greyWalls();
    addBox(grey, placed({0.0f, 0.5f * kPlinthHeight, -0.5f}, 17.0),
           {1.4f, 0.5f * kPlinthHeight, 1.4f});
    const MaterialId paint = fillBox(world, std::move(grey));
    const glm::quat turned = glm::quat_cast(glm::mat3(placed({}, 17.0)));
    spawnMesh(world, makeStatue(), paint, Transform{{0.0f, kPlinthHeight, -0.5f}, turned});
}

void fillCornellHairball(ecs::World& world) {
    fillBox(world, greyWalls());
    const MaterialId hair =
        world.resource<Library>().addMaterial(lambertian("hair", {0.6f, 0.42f, 0.25f}));
    spawnMesh(world, makeHairball(3.0f), hair, Transform{{0.0f, 3.0f, -0.5f}});
}

}  // namespace lampyris::scene::builtin
