// two_rooms: all that the camera sees is lit through a doorway.
#include <cmath>
#include <utility>

#include "scene/builtin/builtin.h"
#include "scene/builtin/cell_room.h"
#include "scene/builtin/shapes.h"
#include "scene/spawn.h"

namespace lampyris::scene::builtin {

namespace {

/// 16 × 5 × 10 m; the wall of 0.2 m stands at x = 0, its doorway is 3 m wide and 4 m high.
const CellRoom& shell() {
    static const CellRoom kShell{{-8.0f, -0.1f, 0.1f, 8.0f},
                                 {0.0f, 4.0f, 5.0f},
                                 {-5.0f, -2.0f, 1.0f, 5.0f},
                                 [](const glm::vec3& centre) {
                                     const bool inDoorway =
                                         centre.y < 4.0f && centre.z > -2.0f && centre.z < 1.0f;
                                     return std::abs(centre.x) > 0.1f || inDoorway;
                                 }};
    return kShell;
}

void spawnShell(ecs::World& world) {
    assets::Mesh plaster;
    assets::Mesh floor;
    assets::Mesh red;
    assets::Mesh teal;
    plaster.name = "walls and ceiling";
    floor.name = "floor";
    red.name = "far wall";
    teal.name = "side wall";
    addCellRoom(shell(), [&](const CellFace& face) -> assets::Mesh& {
        if (face.normal.y > 0.0f) return floor;
        if (face.normal.x > 0.0f && face.centre.x < -1.0f) return red;
        if (face.normal.z > 0.0f && face.centre.x > 1.0f && face.centre.z < -4.0f) return teal;
        return plaster;
    });
    auto& library = world.resource<Library>();
    const auto add = [&](assets::Mesh& mesh, const glm::vec3& albedo) {
        assets::updateBounds(mesh);
        const MaterialId paint = library.addMaterial(lambertian(mesh.name, albedo));
        spawnMesh(world, std::move(mesh), paint);
    };
    add(plaster, glm::vec3(0.75f));
    add(floor, {0.55f, 0.46f, 0.36f});
    add(red, {0.63f, 0.12f, 0.07f});
    add(teal, {0.12f, 0.42f, 0.45f});
}

void spawnThings(ecs::World& world) {
    auto& library = world.resource<Library>();
    const auto add = [&](const char* name, const glm::vec3& albedo, auto&& build) {
        assets::Mesh mesh;
        mesh.name = name;
        build(mesh);
        assets::updateBounds(mesh);
        spawnMesh(world, std::move(mesh), library.addMaterial(lambertian(name, albedo)));
    };
    add("yellow box", {0.75f, 0.55f, 0.08f}, [](assets::Mesh& m) {
        addBox(m, placed({-2.6f, 0.9f, -3.0f}, 31.0), {0.8f, 0.9f, 0.8f});
    });
    add("white sphere", glm::vec3(0.8f), [](assets::Mesh& m) {
        addSphere(m, {-3.6f, 0.9f, 0.4f}, 0.9f, 48);
    });
    add("blue sphere", {0.1f, 0.2f, 0.65f}, [](assets::Mesh& m) {
        addSphere(m, {2.6f, 0.8f, 0.9f}, 0.8f, 48);
    });
    add("green box", {0.15f, 0.5f, 0.12f}, [](assets::Mesh& m) {
        addBox(m, placed({4.6f, 0.6f, -3.3f}, 22.0), {0.9f, 0.6f, 0.9f});
    });
    add("orange ring", {0.75f, 0.32f, 0.06f}, [](assets::Mesh& m) {
        addTorus(m, placed({4.6f, 1.4f, -3.3f}), 0.6f, 0.2f, 96, 48);
    });
    add("columns", glm::vec3(0.75f), [](assets::Mesh& m) {
        addCylinder(m, placed({1.2f, 0.0f, -3.6f}), 0.3f, 4.9f, 64);
        addCylinder(m, placed({-1.2f, 0.0f, -3.6f}), 0.3f, 4.9f, 64);
    });
    add("purple cabinet", {0.4f, 0.14f, 0.45f}, [](assets::Mesh& m) {
        addBox(m, placed({1.3f, 1.3f, 3.6f}, -8.0), {0.6f, 1.3f, 1.0f});
    });
}

}  // namespace

void fillTwoRooms(ecs::World& world) {
    spawnShell(world);
    spawnThings(world);
    spawnLight(world, "light", {-3.4f, 3.7f, -0.9f},
               {.radiusMetres = 0.3f, .powerWatts = glm::vec3(2000.0f)});
    spawnCamera(world, "camera", {7.6f, 2.3f, 2.9f}, {0.0f, 1.6f, -0.6f},
                {.verticalFovRadians = math::kPi / 3.0f});
}

}  // namespace lampyris::scene::builtin
