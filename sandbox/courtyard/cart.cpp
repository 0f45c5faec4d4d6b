// A cart that goes between the street and the square; its wheels turn as it goes.
#include <array>

#include "courtyard/forms.h"
#include "courtyard/movements.h"
#include "courtyard/moving_things.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

using scene::builtin::placed;

constexpr float kWheelRadiusMetres = 0.36f;
constexpr float kMetresPerSecond = 0.9f;
constexpr float kRadiansPerTurn = 6.2831853f;

void addBody(assets::Mesh& mesh) {
    addBlock(mesh, {-0.45f, 0.42f, -0.75f}, {0.45f, 0.5f, 0.75f});
    for (const float side : {-1.0f, 1.0f})
        for (int plank = 0; plank < 2; ++plank) {
            const float y = 0.53f + 0.19f * static_cast<float>(plank);
            addBlock(mesh, {0.44f * side - 0.025f, y, -0.75f},
                     {0.44f * side + 0.025f, y + 0.16f, 0.75f});
            addBlock(mesh, {-0.41f, y, 0.72f * side - 0.025f},
                     {0.41f, y + 0.16f, 0.72f * side + 0.025f});
        }
    for (const float side : {-1.0f, 1.0f})
        addBar(mesh, {0.3f * side, 0.47f, 0.7f}, {0.24f * side, 0.62f, 1.6f}, 0.025f, 12);
    addBar(mesh, {-0.56f, kWheelRadiusMetres, 0.0f}, {0.56f, kWheelRadiusMetres, 0.0f}, 0.03f, 12);
}

/// About x, around the origin.
void addCartWheel(assets::Mesh& mesh) {
    const glm::mat4 upright = glm::mat4_cast(turned({0.0f, 0.0f, 1.0f}, 0.25));
    scene::builtin::addTorus(mesh, upright, kWheelRadiusMetres - 0.035f, 0.035f, 56, 10);
    scene::builtin::addSphere(mesh, glm::vec3(0.0f), 0.075f, 8);
    for (int i = 0; i < 10; ++i) {
        const auto angle = scene::builtin::sinCosTurns(i / 10.0);
        addBar(mesh, glm::vec3(0.0f),
               (kWheelRadiusMetres - 0.03f) *
                   glm::vec3(0.0f, static_cast<float>(angle.cos), static_cast<float>(angle.sin)),
               0.016f);
    }
}

}  // namespace

void spawnCart(ecs::World& world, const Paints& paints) {
    constexpr std::array<glm::vec3, 9> kWay{{{3.4f, 0.03f, 2.4f},
                                             {5.2f, 0.03f, 1.2f},
                                             {7.2f, 0.03f, -0.4f},
                                             {8.6f, 0.03f, -1.4f},
                                             {9.3f, 0.03f, 0.4f},
                                             {8.6f, 0.03f, 0.9f},
                                             {7.2f, 0.03f, -0.3f},
                                             {5.0f, 0.03f, -1.6f},
                                             {2.4f, 0.03f, 0.6f}}};
    const ecs::Entity cart = show(world, "cart", paints.wood, addBody);
    world.add(cart, Travel{std::make_shared<Route>(kWay), kMetresPerSecond, 0.0f});
    for (const float side : {-0.52f, 0.52f}) {
        const ecs::Entity wheel = showBelow(world, cart, "cart's wheel", paints.darkWood,
                                            addCartWheel, {{side, kWheelRadiusMetres, 0.0f}});
        const float turns = kMetresPerSecond / (kRadiansPerTurn * kWheelRadiusMetres);
        world.add(wheel, Spin{{1.0f, 0.0f, 0.0f}, turns});
    }
    showBelow(world, cart, "cart's load", paints.saffron, [](assets::Mesh& mesh) {
        scene::builtin::addRoundedBox(mesh, placed({-0.15f, 0.68f, -0.3f}, 12.0),
                                      {{0.24f, 0.18f, 0.3f}, 0.14f, 3, 1});
        scene::builtin::addRoundedBox(mesh, placed({0.12f, 0.7f, 0.3f}, -20.0),
                                      {{0.25f, 0.2f, 0.28f}, 0.15f, 3, 1});
        scene::builtin::addRoundedBox(mesh, placed({-0.05f, 0.95f, 0.0f}, 40.0),
                                      {{0.22f, 0.14f, 0.3f}, 0.12f, 3, 1});
    });
}

}  // namespace lampyris::courtyard
