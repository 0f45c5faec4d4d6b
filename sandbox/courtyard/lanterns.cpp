#include "courtyard/lanterns.h"

#include <array>

#include "core/check.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/movements.h"
#include "courtyard/moving_things.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {

using scene::builtin::placed;
using scene::builtin::sinCosTurns;

void addLanternCage(assets::Mesh& mesh, const glm::mat4& placement) {
    const auto at = [&](double turns, float radius, float y) {
        const auto angle = sinCosTurns(turns);
        return glm::vec3(placement * glm::vec4(radius * static_cast<float>(angle.cos), y,
                                               radius * static_cast<float>(angle.sin), 1.0f));
    };
    const auto moved = [&](float y) { return glm::translate(placement, {0.0f, y, 0.0f}); };
    for (int i = 0; i < 6; ++i)
        addBar(mesh, at(i / 6.0, 0.14f, -0.19f), at(i / 6.0, 0.17f, 0.19f), 0.008f);
    scene::builtin::addTorus(mesh, moved(-0.19f), 0.14f, 0.013f, 36, 8);
    scene::builtin::addTorus(mesh, moved(0.19f), 0.17f, 0.013f, 36, 8);
    const std::array<glm::vec2, 6> roof{{{0.17f, 0.18f},
                                         {0.2f, 0.2f},
                                         {0.12f, 0.26f},
                                         {0.06f, 0.31f},
                                         {0.025f, 0.33f},
                                         {0.001f, 0.37f}}};
    addLathe(mesh, placement, roof, 24);
}

namespace {

constexpr glm::vec3 kHook{0.9f, 4.7f, -0.4f};  // above the square, on a rope

/// It hangs from the rope and swings with its light.
void spawnSwingingLantern(ecs::World& world, const Paints& paints) {
    show(world, "rope", paints.darkWood, [](assets::Mesh& mesh) {
        std::array<glm::vec3, 33> path;
        for (size_t i = 0; i < path.size(); ++i) {
            const float t = static_cast<float>(i) / 16.0f - 1.0f;
            path[i] = {kHook.x, kHook.y + 0.6f * t * t, kHook.z + 6.3f * t};
        }
        scene::builtin::addTube(mesh, path, 0.018f, 8);
    });
    const ecs::Entity pivot = scene::spawn(world, "lantern's hook", {kHook});
    world.add(pivot, Swing{{0.0f, 0.0f, 1.0f}, 0.05f, 3.4f, 0.0f});
    constexpr glm::vec3 kHanging{0.0f, -1.3f, 0.0f};
    showBelow(world, pivot, "lantern", paints.iron, [&](assets::Mesh& mesh) {
        addLanternCage(mesh, placed(kHanging));
        addBar(mesh, {0.0f, 0.0f, 0.0f}, {0.0f, -0.95f, 0.0f}, 0.01f);
    });
    const ecs::Entity light =
        scene::spawnLight(world, "lantern's light", kHanging,
                          {.radiusMetres = 0.11f, .powerWatts = {740.0f, 510.0f, 270.0f}});
    CHECK(ecs::setParent(world, light, pivot).ok());
}

/// A cool globe under the arcade's ceiling.
void spawnArcadeLamp(ecs::World& world, const Paints& paints) {
    constexpr glm::vec3 kLamp{-4.9f, 2.45f, -7.7f};
    show(world, "arcade's lamp", paints.iron, [&](assets::Mesh& mesh) {
        addLanternCage(mesh, placed(kLamp));
        addBar(mesh, kLamp + glm::vec3(0.0f, 0.34f, 0.0f), {kLamp.x, kCeilingY + 0.02f, kLamp.z},
               0.01f);
    });
    scene::spawnLight(world, "arcade's light", kLamp,
                      {.radiusMetres = 0.12f, .powerWatts = {95.0f, 165.0f, 290.0f}});
}

constexpr glm::vec3 kFireWatts{62.0f, 37.0f, 17.0f};

/// The hearth's fire: its power and its radius swell as the bellows blow.
void spawnFire(ecs::World& world) {
    const ecs::Entity fire =
        scene::spawnLight(world, "fire", kHearth + glm::vec3(0.75f, 1.25f, 0.0f),
                          {.radiusMetres = 0.16f, .powerWatts = kFireWatts});
    world.add(fire, Pulse{kFireWatts, 0.16f, 0.3f, 0.2f, 4.0f});
}

/// A green spark that roams the square, the arcade and the street.
void spawnFirefly(ecs::World& world) {
    constexpr std::array<glm::vec3, 10> kWay{{{1.9f, 1.5f, 1.6f},
                                              {-1.2f, 2.4f, 1.9f},
                                              {-4.6f, 1.2f, 1.3f},
                                              {-4.6f, 1.9f, -3.2f},
                                              {-2.6f, 1.6f, -6.2f},
                                              {0.2f, 1.3f, -7.9f},
                                              {3.0f, 1.7f, -6.2f},
                                              {4.6f, 2.2f, -3.0f},
                                              {7.2f, 1.6f, -0.4f},
                                              {4.6f, 1.0f, 1.2f}}};
    const ecs::Entity firefly = scene::spawnLight(
        world, "firefly", kWay[0], {.radiusMetres = 0.035f, .powerWatts = {16.0f, 40.0f, 9.0f}});
    world.add(firefly, Travel{std::make_shared<Route>(kWay), 1.1f, 0.0f});
}

}  // namespace

void spawnLanterns(ecs::World& world, const Paints& paints) {
    spawnSwingingLantern(world, paints);
    spawnArcadeLamp(world, paints);
    spawnFire(world);
    spawnFirefly(world);
}

}  // namespace lampyris::courtyard
