// conference: a furnished room, closed, with four lamps; about 330 thousand triangles.
#include <cmath>
#include <string>
#include <utility>

#include "scene/builtin/builtin.h"
#include "scene/builtin/cell_room.h"
#include "scene/builtin/conference_parts.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"
#include "scene/spawn.h"

namespace lampyris::scene::builtin {

namespace {

constexpr float kCeiling = 3.4f;
constexpr float kTableTop = 0.75f;
constexpr float kWindowWidth = 3.0f;
constexpr float kWindowBottom = 1.0f;
constexpr float kWindowTop = 2.8f;
constexpr float kLampX[4] = {-3.6f, -1.2f, 1.2f, 3.6f};
constexpr float kWindowX[3] = {-5.5f, -1.5f, 2.5f};  ///< left edges

assets::Material glossy(std::string name, const glm::vec3& colour, float roughness) {
    assets::Material material;
    material.name = std::move(name);
    material.baseColour = glm::vec4(colour, 1.0f);
    material.metallic = 0.0f;
    material.roughness = roughness;
    return material;
}

void spawnPart(ecs::World& world, assets::Mesh mesh, assets::Material material) {
    assets::updateBounds(mesh);
    mesh.name = material.name;
    const MaterialId id = world.resource<Library>().addMaterial(std::move(material));
    spawnMesh(world, std::move(mesh), id);
}

bool inWindow(const glm::vec3& p) {
    bool beside = true;
    for (const float left : kWindowX) beside = beside && (p.x < left || p.x > left + kWindowWidth);
    return !beside && p.y > kWindowBottom && p.y < kWindowTop;
}

/// 14 × 3.4 × 9 m, with three blind windows: niches of 0.3 m.
void spawnRoom(ecs::World& world) {
    const CellRoom room{
        {-7.0f, kWindowX[0], kWindowX[0] + kWindowWidth, kWindowX[1], kWindowX[1] + kWindowWidth,
         kWindowX[2], kWindowX[2] + kWindowWidth, 7.0f},
        {0.0f, kWindowBottom, kWindowTop, kCeiling},
        {-4.8f, -4.5f, 4.5f},
        [](const glm::vec3& centre) { return centre.z > -4.5f || inWindow(centre); }};
    assets::Mesh plaster;
    assets::Mesh carpet;
    assets::Mesh sky;
    assets::Mesh accent;
    addCellRoom(room, [&](const CellFace& face) -> assets::Mesh& {
        if (face.normal.y > 0.0f && face.centre.y < 0.5f) return carpet;
        if (face.centre.z < -4.75f) return sky;
        if (face.normal.x > 0.0f && face.centre.x < -6.9f) return accent;
        return plaster;
    });
    spawnPart(world, std::move(plaster), lambertian("plaster", {0.75f, 0.73f, 0.69f}));
    spawnPart(world, std::move(carpet), lambertian("carpet", {0.22f, 0.26f, 0.34f}));
    spawnPart(world, std::move(sky), lambertian("window panes", {0.25f, 0.35f, 0.5f}));
    spawnPart(world, std::move(accent), lambertian("end wall", {0.5f, 0.16f, 0.1f}));
}

/// Calls place(placement) for eighteen seats around the table, each facing it.
template <typename Place>
void forEachSeat(Place&& place) {
    for (int i = 0; i < 8; ++i) {
        const float x = -4.2f + 1.2f * static_cast<float>(i);
        const float jitter = 0.12f * hashSigned(7, static_cast<uint32_t>(i));
        const double turn = 16.0 * hashSigned(8, static_cast<uint32_t>(i));
        place(placed({x, 0.0f, -1.55f + jitter}, turn));
        place(placed({x, 0.0f, 1.55f - jitter}, 180.0 - turn));
    }
    place(placed({-5.6f, 0.0f, 0.0f}, 90.0));
    place(placed({5.6f, 0.0f, 0.1f}, -98.0));
}

void spawnSeats(ecs::World& world) {
    assets::Mesh cushions;
    assets::Mesh frames;
    assets::Mesh crockery;
    forEachSeat([&](const glm::mat4& seat) {
        addChairCushions(cushions, seat);
        addChairFrame(frames, seat);
        addCup(crockery, glm::translate(seat, {0.25f, kTableTop, 0.85f}));
        addBox(crockery, glm::translate(seat, {-0.05f, kTableTop + 0.003f, 0.8f}),
               {0.105f, 0.003f, 0.148f});
    });
    spawnPart(world, std::move(cushions), lambertian("chair cushions", {0.14f, 0.3f, 0.16f}));
    spawnPart(world, std::move(frames), glossy("chair frames", glm::vec3(0.12f), 0.35f));
    spawnPart(world, std::move(crockery), glossy("cups and paper", glm::vec3(0.8f), 0.4f));
}

void spawnWood(ecs::World& world) {
    assets::Mesh wood;
    addRoundedBox(wood, placed({0.0f, kTableTop - 0.04f, 0.0f}),
                  {{4.9f, 0.04f, 1.1f}, 0.035f, 8, 24});
    for (const float x : {-3.2f, 0.0f, 3.2f}) {
        addBox(wood, placed({x, 0.5f * (kTableTop - 0.08f), 0.0f}),
               {0.12f, 0.5f * (kTableTop - 0.08f), 0.55f});
    }
    for (int shelf = 0; shelf < 6; ++shelf) {
        addBox(wood, placed({0.0f, 0.2f + 0.4f * static_cast<float>(shelf), 4.3f}),
               {3.0f, 0.02f, 0.18f});
    }
    for (const float x : {-3.0f, -1.0f, 1.0f, 3.0f}) {
        addBox(wood, placed({x, 1.1f, 4.3f}), {0.02f, 1.1f, 0.18f});
    }
    addRoundedBox(wood, placed({-6.96f, 1.05f, 2.6f}), {{0.03f, 1.05f, 0.5f}, 0.02f, 3, 2});
    spawnPart(world, std::move(wood), glossy("wood", {0.38f, 0.22f, 0.11f}, 0.3f));
}

void spawnBooks(ecs::World& world) {
    constexpr int kColours = 3;
    const glm::vec3 colours[kColours] = {
        {0.45f, 0.1f, 0.08f}, {0.12f, 0.18f, 0.4f}, {0.6f, 0.5f, 0.3f}};
    assets::Mesh books[kColours];
    uint32_t book = 0;
    for (int shelf = 0; shelf < 5; ++shelf) {
        const float foot = 0.22f + 0.4f * static_cast<float>(shelf);
        for (float x = -2.95f; x < 2.9f; ++book) {
            const float half = 0.02f + 0.02f * hashUnit(11, book);
            const float tall = 0.11f + 0.06f * hashUnit(12, book);
            x += 2.0f * half + 0.004f;
            const bool gap = hashUnit(13, book) < 0.12f;
            const float toPost = std::abs(std::abs(x - half) - 1.0f);
            if (gap || toPost < half + 0.03f || x > 2.95f) continue;
            assets::Mesh& mesh = books[hashBits(14, book) % kColours];
            addRoundedBox(mesh, placed({x - half, foot + tall, 4.28f}),
                          {{half, tall, 0.12f}, 0.006f, 1, 1});
        }
    }
    for (int i = 0; i < kColours; ++i) {
        spawnPart(world, std::move(books[i]),
                  lambertian("books " + std::to_string(i + 1), colours[i]));
    }
}

void spawnFittings(ecs::World& world) {
    assets::Mesh fabric;
    assets::Mesh metal;
    assets::Mesh leaves;
    assets::Mesh pots;
    for (const float left : kWindowX) {
        addBlind(metal, {left, kWindowTop, -4.62f}, {kWindowWidth, 0.9f});
        addCurtain(fabric, {left - 0.35f, 3.1f, -4.38f}, {0.7f, 2.9f});
        addCurtain(fabric, {left + kWindowWidth - 0.35f, 3.1f, -4.38f}, {0.7f, 2.9f});
    }
    for (const float x : kLampX) addLampRing(metal, {x, 2.5f, 0.0f}, kCeiling);
    for (const glm::vec3 foot : {glm::vec3(-6.3f, 0.0f, -3.8f), glm::vec3(6.3f, 0.0f, -3.8f)}) {
        addCylinder(pots, placed(foot), 0.24f, 0.5f, 64);
        addLeaves(leaves, foot + glm::vec3(0.0f, 0.5f, 0.0f), foot.x < 0.0f ? 21 : 22);
    }
    spawnPart(world, std::move(fabric), lambertian("curtains", {0.65f, 0.55f, 0.38f}));
    spawnPart(world, std::move(metal), glossy("lamp rings and blinds", glm::vec3(0.6f), 0.25f));
    spawnPart(world, std::move(leaves), glossy("leaves", {0.1f, 0.32f, 0.07f}, 0.5f));
    spawnPart(world, std::move(pots), lambertian("pots", {0.55f, 0.24f, 0.13f}));
}

}  // namespace

void fillConference(ecs::World& world) {
    spawnRoom(world);
    spawnSeats(world);
    spawnWood(world);
    spawnBooks(world);
    spawnFittings(world);
    for (int i = 0; i < 4; ++i) {
        spawnLight(world, "lamp " + std::to_string(i + 1), {kLampX[i], 2.5f, 0.0f},
                   {.radiusMetres = 0.12f, .powerWatts = {200.0f, 180.0f, 155.0f}});
    }
    spawnCamera(world, "camera", {6.6f, 2.15f, 3.6f}, {-1.2f, 0.75f, -0.9f},
                {.verticalFovRadians = math::kPi / 3.0f});
}

}  // namespace lampyris::scene::builtin
