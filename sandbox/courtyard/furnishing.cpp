// Plants and benches of the square; shelves, a table and a rug of the study.
#include <array>

#include "courtyard/building.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

using scene::builtin::placed;
using scene::builtin::sinCosTurns;

struct Pot {
    glm::vec3 foot;
    float size;
};
constexpr std::array<Pot, 6> kPots{{{{4.9f, 0.02f, -5.0f}, 1.2f},
                                    {{-6.2f, 0.02f, -4.9f}, 1.1f},
                                    {{-6.3f, 0.02f, -2.2f}, 0.9f},
                                    {{2.0f, 0.02f, 4.6f}, 1.15f},
                                    {{6.3f, 0.02f, -5.2f}, 0.8f},
                                    {{0.6f, 0.02f, 5.2f}, 0.9f}}};

void addPot(assets::Mesh& mesh, const Pot& pot) {
    const std::array<glm::vec2, 12> profile{{{0.2f, 0.0f},
                                             {0.22f, 0.04f},
                                             {0.27f, 0.2f},
                                             {0.3f, 0.36f},
                                             {0.3f, 0.44f},
                                             {0.34f, 0.46f},
                                             {0.34f, 0.54f},
                                             {0.34f, 0.54f},
                                             {0.29f, 0.54f},
                                             {0.29f, 0.54f},
                                             {0.28f, 0.46f},
                                             {0.001f, 0.46f}}};
    addLathe(mesh, glm::scale(placed(pot.foot), glm::vec3(pot.size)), profile, 48);
}

/// A blade that grows out of the pot and bends over; of two sides.
void addBlade(assets::Mesh& mesh, const Pot& pot, uint32_t seed) {
    const auto angle = sinCosTurns(scene::builtin::hashUnit(seed, 0));
    const glm::vec3 out(static_cast<float>(angle.cos), 0.0f, static_cast<float>(angle.sin));
    const glm::vec3 across(-out.z, 0.0f, out.x);
    const float reach = pot.size * (0.25f + 0.45f * scene::builtin::hashUnit(seed, 1));
    const float height = pot.size * (0.5f + 0.9f * scene::builtin::hashUnit(seed, 2));
    const glm::vec3 root = pot.foot + glm::vec3(0.0f, 0.46f * pot.size, 0.0f) +
                           0.14f * pot.size * scene::builtin::hashUnit(seed, 3) * out;
    for (const float side : {1.0f, -1.0f}) {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        constexpr int kRows = 11;
        for (int row = 0; row < kRows; ++row) {
            const float t = static_cast<float>(row) / (kRows - 1);
            const glm::vec3 rib =
                root + reach * t * t * out + glm::vec3(0.0f, height * t * (1.35f - 0.6f * t), 0.0f);
            const float width =
                pot.size * (0.004f + 0.055f * static_cast<float>(sinCosTurns(0.08 + 0.42 * t).sin));
            for (int column = -1; column <= 1; ++column) {
                const float x = side * static_cast<float>(column);
                mesh.positions.push_back(rib + width * x * across +
                                         glm::vec3(0.0f, 0.25f * width * glm::abs(x), 0.0f) -
                                         0.001f * side * out);
            }
        }
        addGrid(mesh, first, 3, kRows, false);
        smoothNormals(mesh, first);
    }
}

void addSeat(assets::Mesh& mesh, const glm::mat4& placement) {
    const auto box = [&](const glm::vec3& centre, const glm::vec3& half) {
        scene::builtin::addRoundedBox(mesh, glm::translate(placement, centre), {half, 0.02f, 1, 1});
    };
    for (int i = 0; i < 3; ++i)
        box({0.0f, 0.47f, -0.16f + 0.16f * static_cast<float>(i)}, {0.75f, 0.03f, 0.07f});
    for (const float x : {-0.6f, 0.6f}) box({x, 0.22f, 0.0f}, {0.07f, 0.22f, 0.2f});
}

constexpr glm::vec3 kShelf{-12.4f, 0.0f, -6.2f};  // at the study's west wall, 2.6 m long

void addShelf(assets::Mesh& mesh) {
    for (int i = 0; i < 5; ++i) {
        const float y = 0.1f + 0.5f * static_cast<float>(i);
        addBlock(mesh, {kShelf.x, y, kShelf.z - 1.3f},
                 {kShelf.x + 0.36f, y + 0.05f, kShelf.z + 1.3f});
    }
    for (const float z : {-1.34f, 1.3f})
        addBlock(mesh, {kShelf.x, 0.0f, kShelf.z + z},
                 {kShelf.x + 0.38f, 2.25f, kShelf.z + z + 0.05f});
    scene::builtin::addCylinder(mesh, placed({-9.8f, 0.72f, -6.6f}), 0.75f, 0.06f, 64);
    scene::builtin::addCylinder(mesh, placed({-9.8f, 0.0f, -6.6f}), 0.09f, 0.73f, 24);
}

void addBooks(assets::Mesh& mesh, uint32_t dye) {
    uint32_t number = 0;
    for (int shelf = 0; shelf < 4; ++shelf) {
        float z = kShelf.z - 1.27f;
        while (z < kShelf.z + 1.2f) {
            const uint32_t seed = ++number;
            const float thick = 0.03f + 0.04f * scene::builtin::hashUnit(31, 3 * seed);
            const float high = 0.26f + 0.13f * scene::builtin::hashUnit(31, 3 * seed + 1);
            const float y = 0.151f + 0.5f * static_cast<float>(shelf);
            if (scene::builtin::hashBits(31, 3 * seed + 2) % 3 == dye)
                scene::builtin::addBox(
                    mesh, placed({kShelf.x + 0.17f, y + 0.5f * high, z + 0.5f * thick}),
                    {0.11f, 0.5f * high, 0.5f * thick - 0.0015f});
            z += thick;
        }
    }
}

}  // namespace

void spawnFurnishing(ecs::World& world, const Paints& paints) {
    show(world, "pots", paints.clay, [](assets::Mesh& mesh) {
        for (const Pot& pot : kPots) addPot(mesh, pot);
    });
    show(world, "plants", paints.leaf, [](assets::Mesh& mesh) {
        for (uint32_t i = 0; i < kPots.size(); ++i)
            for (uint32_t blade = 0; blade < 48; ++blade) addBlade(mesh, kPots[i], 100 * i + blade);
    });
    show(world, "seats", paints.wood, [](assets::Mesh& mesh) {
        addSeat(mesh, placed({-6.5f, 0.02f, -3.5f}, 90.0));
        addSeat(mesh, placed({1.4f, 0.0f, -8.6f}));
        addSeat(mesh, placed({6.5f, 0.02f, 4.2f}, -90.0));
    });
    show(world, "shelf and table", paints.wood, addShelf);
    const scene::MaterialId dyes[] = {paints.crimson, paints.saffron, paints.teal};
    for (uint32_t dye = 0; dye < 3; ++dye)
        show(world, "books", dyes[dye], [&](assets::Mesh& mesh) { addBooks(mesh, dye); });
    show(world, "rug", paints.crimson, [](assets::Mesh& mesh) {
        scene::builtin::addCylinder(mesh, placed({-9.8f, 0.001f, -6.6f}), 1.7f, 0.015f, 64);
    });
}

}  // namespace lampyris::courtyard
