// The workshop: a hearth, an anvil, barrels, a bench with jars.
#include <array>

#include "courtyard/building.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

using scene::builtin::placed;

void addHearth(assets::Mesh& mesh) {
    const glm::vec3& at = kHearth;
    addBlock(mesh, at + glm::vec3(-0.72f, -0.02f, -0.9f), at + glm::vec3(0.6f, 0.85f, 0.9f), 0.03f);
    // A rim around the coals.
    addBlock(mesh, at + glm::vec3(-0.72f, 0.84f, -0.9f), at + glm::vec3(-0.5f, 1.0f, 0.9f), 0.02f);
    addBlock(mesh, at + glm::vec3(-0.49f, 0.84f, -0.9f), at + glm::vec3(0.6f, 1.0f, -0.7f), 0.02f);
    addBlock(mesh, at + glm::vec3(-0.49f, 0.84f, 0.7f), at + glm::vec3(0.6f, 1.0f, 0.9f), 0.02f);
    const std::array<glm::vec2, 6> hood{{{1.0f, 2.15f},
                                         {1.02f, 2.25f},
                                         {0.75f, 2.6f},
                                         {0.5f, 2.9f},
                                         {0.36f, 3.1f},
                                         {0.34f, 3.42f}}};
    addLathe(mesh, placed(at + glm::vec3(0.4f, 0.0f, 0.0f)), hood, 48);
    const std::array<glm::vec2, 3> within{{{0.3f, 3.42f}, {0.34f, 3.0f}, {1.0f, 2.15f}}};
    addLathe(mesh, placed(at + glm::vec3(0.4f, 0.0f, 0.0f)), within, 48);
}

void addCoals(assets::Mesh& mesh) {
    for (uint32_t i = 0; i < 60; ++i) {
        const glm::vec3 offset(0.05f + 0.45f * scene::builtin::hashSigned(5, 3 * i),
                               0.88f + 0.05f * scene::builtin::hashUnit(5, 3 * i + 1),
                               0.62f * scene::builtin::hashSigned(5, 3 * i + 2));
        scene::builtin::addSphere(mesh, kHearth + offset, 0.07f, 2);
    }
}

void addBarrel(assets::Mesh& mesh, const glm::vec3& foot) {
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= 16; ++i) {
        const float t = static_cast<float>(i) / 8.0f - 1.0f;
        profile.emplace_back(0.36f - 0.07f * t * t, 0.44f + 0.44f * t);
    }
    profile.insert(profile.end(), {{0.29f, 0.88f},
                                   {0.27f, 0.88f},
                                   {0.27f, 0.88f},
                                   {0.27f, 0.83f},
                                   {0.27f, 0.83f},
                                   {0.001f, 0.83f}});
    addLathe(mesh, placed(foot), profile, 24);
}

void addHoops(assets::Mesh& mesh, const glm::vec3& foot) {
    for (const float y : {0.1f, 0.3f, 0.58f, 0.78f}) {
        const float t = (y - 0.44f) / 0.44f;
        scene::builtin::addTorus(mesh, placed(foot + glm::vec3(0.0f, y, 0.0f)),
                                 0.36f - 0.07f * t * t, 0.014f, 32, 5);
    }
}

constexpr std::array<glm::vec3, 5> kBarrels{{{-8.0f, 0.0f, -2.4f},
                                             {-8.8f, 0.0f, -2.5f},
                                             {-11.9f, 0.0f, 3.4f},
                                             {-11.1f, 0.0f, 3.5f},
                                             {-6.5f, 0.03f, 1.75f}}};

void addAnvil(assets::Mesh& mesh) {
    constexpr glm::vec3 kAt{-9.7f, 0.0f, 0.7f};
    addBlock(mesh, kAt + glm::vec3(-0.12f, 0.6f, -0.16f), kAt + glm::vec3(0.12f, 0.7f, 0.16f),
             0.02f);
    addBlock(mesh, kAt + glm::vec3(-0.07f, 0.69f, -0.1f), kAt + glm::vec3(0.07f, 0.81f, 0.1f),
             0.02f);
    addBlock(mesh, kAt + glm::vec3(-0.11f, 0.8f, -0.24f), kAt + glm::vec3(0.11f, 0.92f, 0.2f),
             0.02f);
    const std::array<glm::vec2, 5> horn{
        {{0.09f, 0.0f}, {0.085f, 0.1f}, {0.06f, 0.2f}, {0.03f, 0.28f}, {0.001f, 0.32f}}};
    addLathe(mesh,
             placed(kAt + glm::vec3(0.0f, 0.83f, 0.18f)) * glm::mat4_cast(turned({1, 0, 0}, 0.25)),
             horn, 24);
}

void addBench(assets::Mesh& mesh) {
    addBlock(mesh, {-10.6f, 0.86f, 3.25f}, {-8.2f, 0.94f, 3.95f});
    for (const float x : {-10.5f, -8.4f})
        for (const float z : {3.35f, 3.8f})
            addBlock(mesh, {x, 0.0f, z}, {x + 0.1f, 0.87f, z + 0.1f});
    addBlock(mesh, {-10.6f, 1.7f, 3.7f}, {-8.2f, 1.75f, 3.99f});
    // The stump below the anvil.
    scene::builtin::addCylinder(mesh, placed({-9.7f, 0.0f, 0.7f}), 0.3f, 0.61f, 40);
}

void addJar(assets::Mesh& mesh, const glm::vec3& foot, float size) {
    const std::array<glm::vec2, 9> profile{{{0.07f, 0.0f},
                                            {0.1f, 0.05f},
                                            {0.12f, 0.13f},
                                            {0.1f, 0.22f},
                                            {0.06f, 0.27f},
                                            {0.05f, 0.31f},
                                            {0.07f, 0.34f},
                                            {0.05f, 0.34f},
                                            {0.001f, 0.3f}}};
    addLathe(mesh, glm::scale(placed(foot), glm::vec3(size)), profile, 20);
}

}  // namespace

void spawnWorkshop(ecs::World& world, const Paints& paints) {
    show(world, "hearth", paints.stone, addHearth);
    show(world, "coals", paints.darkWood, addCoals);
    show(world, "cupboard", paints.teal, [](assets::Mesh& mesh) {
        addBlock(mesh, {-12.2f, 0.0f, -2.99f}, {-10.8f, 1.9f, -2.45f}, 0.02f);
        for (const float x : {-12.12f, -11.47f})
            addBlock(mesh, {x, 0.12f, -2.46f}, {x + 0.6f, 1.8f, -2.42f}, 0.015f);
    });
    show(world, "anvil", paints.iron, addAnvil);
    show(world, "bench", paints.wood, addBench);
    show(world, "barrels", paints.wood, [](assets::Mesh& mesh) {
        for (const glm::vec3& foot : kBarrels) addBarrel(mesh, foot);
    });
    show(world, "hoops", paints.iron, [](assets::Mesh& mesh) {
        for (const glm::vec3& foot : kBarrels) addHoops(mesh, foot);
        for (int i = 0; i < 4; ++i) {  // the window's bars
            const float z = kWindow.lower.z + 0.24f * static_cast<float>(i + 1);
            addBar(mesh, {-7.2f, 1.18f, z}, {-7.2f, 2.22f, z}, 0.02f, 12);
        }
    });
    show(world, "jars", paints.glaze, [](assets::Mesh& mesh) {
        for (uint32_t i = 0; i < 7; ++i)
            addJar(mesh,
                   {-10.35f + 0.32f * static_cast<float>(i), i % 2 == 0 ? 1.75f : 0.94f,
                    i % 2 == 0 ? 3.84f : 3.6f},
                   0.8f + 0.5f * scene::builtin::hashUnit(9, i));
    });
}

}  // namespace lampyris::courtyard
