#include "courtyard/player.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/lanterns.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

constexpr float kStepMetres = 0.05f;  // [chosen] under the thinnest wall, so that none is jumped

void addBody(assets::Mesh& mesh) {
    const std::array<glm::vec2, 14> profile{{{0.001f, 0.03f},
                                             {0.16f, 0.03f},
                                             {0.24f, 0.08f},
                                             {0.28f, 0.17f},
                                             {0.29f, 0.3f},
                                             {0.27f, 0.45f},
                                             {0.22f, 0.58f},
                                             {0.15f, 0.65f},
                                             {0.15f, 0.65f},
                                             {0.15f, 0.68f},
                                             {0.15f, 0.68f},
                                             {0.08f, 0.7f},
                                             {0.06f, 0.74f},
                                             {0.06f, 0.8f}}};
    addLathe(mesh, glm::mat4(1.0f), profile, 48);
    scene::builtin::addSphere(mesh, {0.0f, 0.88f, 0.0f}, 0.17f, 12);
}

void addTrim(assets::Mesh& mesh) {
    using scene::builtin::placed;
    scene::builtin::addTorus(mesh, placed({0.0f, 0.3f, 0.0f}), 0.29f, 0.02f, 40, 8);
    for (const float side : {-1.0f, 1.0f})
        scene::builtin::addSphere(mesh, {0.07f * side, 0.91f, 0.145f}, 0.035f, 6);
    const std::array<glm::vec3, 5> arm{{{0.2f, 0.5f, 0.0f},
                                        {0.34f, 0.55f, 0.1f},
                                        {0.4f, 0.72f, 0.22f},
                                        {0.4f, 0.95f, 0.3f},
                                        {0.4f, 1.12f, 0.32f}}};
    scene::builtin::addTube(mesh, arm, 0.022f, 12);
    for (int i = 0; i < 3; ++i) {
        const auto angle = scene::builtin::sinCosTurns(i / 3.0);
        scene::builtin::addSphere(
            mesh,
            {0.17f * static_cast<float>(angle.cos), 0.07f, 0.17f * static_cast<float>(angle.sin)},
            0.07f, 6);
    }
}

/// From one place as far towards another as walls allow, axis by axis.
glm::vec3 walked(glm::vec3 from, const glm::vec2& way, float radius) {
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(way) / kStepMetres)));
    const glm::vec2 step = way / static_cast<float>(steps);
    for (int i = 0; i < steps; ++i) {
        glm::vec3 next = from + glm::vec3(step.x, 0.0f, 0.0f);
        if (isWalkable(next, radius)) from = next;
        next = from + glm::vec3(0.0f, 0.0f, step.y);
        if (isWalkable(next, radius)) from = next;
    }
    from.y = floorAt(from);
    return from;
}

/// The room shrunk by the radius, but for the two sides by which an opening joins its rooms:
/// there it reaches into them.
bool holdsWalker(const Room& room, const glm::vec3& at, float radius) {
    if (room.lower.y > 0.0f) return false;
    const glm::vec3 size = room.upper - room.lower;
    constexpr float kThickestWall = 0.45f;
    const float marginX = size.x < kThickestWall ? -radius : radius;
    const float marginZ = size.z < kThickestWall ? -radius : radius;
    return at.x >= room.lower.x + marginX && at.x <= room.upper.x - marginX &&
           at.z >= room.lower.z + marginZ && at.z <= room.upper.z - marginZ;
}

}  // namespace

bool isWalkable(const glm::vec3& position, float radiusMetres) {
    static const std::vector<Room> kRooms = rooms();
    const glm::vec2 toFountain(position.x - kFountain.x, position.z - kFountain.z);
    if (glm::length(toFountain) < kFountainRadiusMetres + radiusMetres) return false;
    return std::any_of(kRooms.begin(), kRooms.end(),
                       [&](const Room& room) { return holdsWalker(room, position, radiusMetres); });
}

void spawnPlayer(ecs::World& world, const Paints& paints) {
    const ecs::Entity player =
        show(world, "player", paints.white, addBody, {{3.0f, kSlabTopY, -2.6f}});
    world.add(player, Player{});
    showBelow(world, player, "player's trim", paints.copper, addTrim);
    constexpr glm::vec3 kLamp{0.4f, 0.92f, 0.42f};
    showBelow(world, player, "player's lantern", paints.iron,
              [](assets::Mesh& mesh) { addLanternCage(mesh, glm::mat4(1.0f)); },
              {kLamp, turned({0.0f, 1.0f, 0.0f}, 0.0), glm::vec3(0.55f)});
    const ecs::Entity light =
        scene::spawnLight(world, "player's light", kLamp,
                          {.radiusMetres = 0.05f, .powerWatts = {60.0f, 45.0f, 22.0f}});
    CHECK(ecs::setParent(world, light, player).ok());
}

void steer(ecs::World& world, const glm::vec2& direction, float seconds) {
    const float length = glm::length(direction);
    if (!(length > 0.0f) || !(seconds > 0.0f)) return;
    const glm::vec2 way = direction / glm::max(length, 1.0f);
    for (const auto& [entity, player, transform] : world.view<Player, scene::Transform>()) {
        const glm::vec3 to = walked(transform.translation, way * player.metresPerSecond * seconds,
                                    player.radiusMetres);
        auto& placed = world.edit<scene::Transform>(entity);
        placed.translation = to;
        placed.rotation = scene::rotationFacing(glm::vec3(way.x, 0.0f, way.y));
    }
}

}  // namespace lampyris::courtyard
