// Cloth that hangs and sways: a chain of joints, each of which swings a little later than the one
// above it.
#include <utility>

#include "core/check.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/movements.h"
#include "courtyard/moving_things.h"
#include "scene/builtin/numbers.h"

namespace lampyris::courtyard {
namespace {

constexpr uint32_t kJoints = 5;
constexpr float kLengthMetres = 1.7f;
constexpr float kWidthMetres = 0.75f;
constexpr float kPiece = kLengthMetres / kJoints;

/// Two sides, 1 cm apart, from y = 0 down; joint k begins k pieces down.
void addCloth(assets::Mesh& mesh) {
    constexpr uint32_t kColumns = 14;
    constexpr uint32_t kRows = 40;
    for (const float side : {1.0f, -1.0f}) {
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        for (uint32_t row = 0; row <= kRows; ++row) {
            const float t = static_cast<float>(row) / kRows;
            for (uint32_t column = 0; column <= kColumns; ++column) {
                const float s = 2.0f * static_cast<float>(column) / kColumns - 1.0f;
                const float point = t == 1.0f ? 0.22f * (1.0f - glm::abs(s)) : 0.0f;
                const auto fold = static_cast<float>(scene::builtin::sinCosTurns(1.5 * s).cos);
                mesh.positions.emplace_back(0.5f * kWidthMetres * s * side,
                                            -kLengthMetres * t - point,
                                            0.03f * t * fold + 0.005f * side);
                const float at = glm::min(t * kJoints, kJoints - 0.001f);
                const auto joint = static_cast<uint32_t>(at);
                const float below = glm::smoothstep(0.3f, 1.0f, at - static_cast<float>(joint));
                const uint32_t next = glm::min(joint + 1, kJoints - 1);
                mesh.joints.emplace_back(joint, next, 0, 0);
                mesh.weights.emplace_back(1.0f - below, below, 0.0f, 0.0f);
            }
        }
        addGrid(mesh, first, kColumns + 1, kRows + 1, false);
        for (size_t i = mesh.indices.size() - 6u * kColumns * kRows; i < mesh.indices.size();
             i += 3)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
        smoothNormals(mesh, first);
    }
}

void spawnBanner(ecs::World& world, scene::MeshId mesh, scene::MaterialId paint,
                 const scene::Transform& place, float phase) {
    const ecs::Entity banner = scene::spawn(world, "banner", place);
    world.add(banner, scene::MeshInstance{mesh, paint});
    scene::Skin skin;
    ecs::Entity above = banner;
    for (uint32_t k = 0; k < kJoints; ++k) {
        const float down = k == 0 ? 0.0f : -kPiece;
        const ecs::Entity joint = scene::spawn(world, "banner's joint", {{0.0f, down, 0.0f}});
        CHECK(ecs::setParent(world, joint, above).ok());
        world.add(joint, Swing{{1.0f, 0.0f, 0.0f},
                               0.012f + 0.004f * static_cast<float>(k),
                               3.0f,
                               phase - 0.11f * static_cast<float>(k),
                               -0.008f});
        skin.joints.push_back(joint);
        skin.inverseBindMatrices.push_back(
            glm::translate(glm::mat4(1.0f), {0.0f, kPiece * static_cast<float>(k), 0.0f}));
        above = joint;
    }
    world.add(banner, std::move(skin));
}

}  // namespace

void spawnBanners(ecs::World& world, const Paints& paints) {
    assets::Mesh mesh;
    mesh.name = "banner";
    addCloth(mesh);
    assets::updateBounds(mesh);
    const scene::MeshId cloth = world.resource<scene::Library>().addMesh(std::move(mesh));
    const scene::MaterialId dyes[] = {paints.crimson, paints.saffron, paints.violet,
                                      paints.crimson};
    for (int i = 0; i < 4; ++i) {
        const float x = archWest(i) + 2.4f;
        spawnBanner(world, cloth, dyes[i], {{x, 5.95f, -5.78f}}, 0.17f * static_cast<float>(i));
    }
    show(world, "banner poles", paints.iron, [](assets::Mesh& poles) {
        for (int i = 0; i < 4; ++i) {
            const float x = archWest(i) + 2.4f;
            addBar(poles, {x - 0.45f, 5.95f, -5.78f}, {x + 0.45f, 5.95f, -5.78f}, 0.02f, 12);
            addBar(poles, {x, 5.95f, -6.05f}, {x, 5.95f, -5.76f}, 0.02f, 12);
        }
    });
}

}  // namespace lampyris::courtyard
