// The fountain: a basin, a bowl on a stem, and water whose waves are four morph targets.
#include <array>

#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/movements.h"
#include "courtyard/moving_things.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

using scene::builtin::placed;
using scene::builtin::sinCosTurns;

constexpr uint32_t kSides = 48;

struct Disc {
    float radius;
    uint32_t rings;
};

/// A flat disc at y = 0 and, for each target, waves that run outwards: the sum of a sine's and a
/// cosine's target is a wave at any phase. Targets 2 and 3 run twice as fast, and across.
void addWater(assets::Mesh& mesh, const Disc& disc, float height) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    mesh.morphTargets.resize(4);
    for (uint32_t ring = 0; ring <= disc.rings; ++ring) {
        // The middle is a ring too small to be seen: no vertex needs a rule of its own.
        const float share = glm::max(static_cast<float>(ring) / disc.rings, 0.002f);
        for (uint32_t side = 0; side < kSides; ++side) {
            const auto angle = sinCosTurns(-static_cast<double>(side) / kSides);
            const glm::vec3 out(static_cast<float>(angle.cos), 0.0f, static_cast<float>(angle.sin));
            mesh.positions.push_back(disc.radius * share * out);
            mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
            const float calm = 1.0f - share * share;  // none at the rim
            const std::array<double, 2> turns{3.0 * share,
                                              2.0 * share * static_cast<double>(out.x) + 0.1};
            for (size_t k = 0; k < 4; ++k) {
                const auto wave = sinCosTurns(turns[k / 2]);
                const auto value = static_cast<float>(k % 2 == 0 ? wave.cos : -wave.sin);
                const auto slope = static_cast<float>(k % 2 == 0 ? -wave.sin : -wave.cos);
                const float steep = (k < 2 ? 18.8f : 12.6f) * height * calm / disc.radius;
                const glm::vec3 along = k < 2 ? out : glm::vec3(1.0f, 0.0f, 0.0f);
                mesh.morphTargets[k].positions.emplace_back(0.0f, height * calm * value, 0.0f);
                mesh.morphTargets[k].normals.push_back(-steep * slope * along);
            }
        }
    }
    addGrid(mesh, first, kSides, disc.rings + 1, true);
    mesh.morphWeights.assign(4, 0.0f);
}

void addBasin(assets::Mesh& mesh) {
    const std::array<glm::vec2, 14> profile{{{1.5f, 0.0f},
                                             {1.5f, 0.12f},
                                             {1.5f, 0.12f},
                                             {1.4f, 0.16f},
                                             {1.36f, 0.25f},
                                             {1.37f, 0.36f},
                                             {1.42f, 0.43f},
                                             {1.5f, 0.46f},
                                             {1.5f, 0.55f},
                                             {1.5f, 0.55f},
                                             {1.24f, 0.55f},
                                             {1.24f, 0.55f},
                                             {1.2f, 0.15f},
                                             {0.001f, 0.12f}}};
    addLathe(mesh, placed(kFountain), profile, 96);
    const std::array<glm::vec2, 16> stem{{{0.3f, 0.1f},
                                          {0.26f, 0.35f},
                                          {0.17f, 0.55f},
                                          {0.13f, 0.8f},
                                          {0.17f, 0.92f},
                                          {0.2f, 0.98f},
                                          {0.14f, 1.05f},
                                          {0.2f, 1.15f},
                                          {0.42f, 1.24f},
                                          {0.62f, 1.36f},
                                          {0.7f, 1.46f},
                                          {0.7f, 1.5f},
                                          {0.63f, 1.5f},
                                          {0.63f, 1.5f},
                                          {0.5f, 1.38f},
                                          {0.1f, 1.34f}}};
    addLathe(mesh, placed(kFountain), stem, 72);
    const std::array<glm::vec2, 9> finial{{{0.1f, 1.34f},
                                           {0.06f, 1.6f},
                                           {0.05f, 1.75f},
                                           {0.1f, 1.82f},
                                           {0.13f, 1.9f},
                                           {0.1f, 1.98f},
                                           {0.05f, 2.03f},
                                           {0.03f, 2.1f},
                                           {0.001f, 2.18f}}};
    addLathe(mesh, placed(kFountain), finial, 48);
}

void spawnWater(ecs::World& world, const Paints& paints, const char* name, const Disc& disc,
                float y) {
    const ecs::Entity water =
        show(world, name, paints.water, [&](assets::Mesh& mesh) { addWater(mesh, disc, 0.028f); },
             {kFountain + glm::vec3(0.0f, y, 0.0f)});
    world.add(water, scene::MorphWeights{std::vector<float>(4, 0.0f)});
    world.add(water, Ripple{2.4f, 1.0f});
}

}  // namespace

void spawnFountain(ecs::World& world, const Paints& paints) {
    show(world, "fountain", paints.stone, addBasin);
    spawnWater(world, paints, "basin's water", {1.23f, 24}, 0.44f);
    spawnWater(world, paints, "bowl's water", {0.615f, 16}, 1.465f);
}

}  // namespace lampyris::courtyard
