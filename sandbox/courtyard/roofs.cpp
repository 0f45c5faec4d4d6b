// Eaves of clay tiles, and the shutters of the upper windows.
#include "courtyard/building.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

using scene::builtin::placed;

/// A half round tile from `top` down to `foot`, bulging upwards.
void addTile(assets::Mesh& mesh, const glm::vec3& top, const glm::vec3& foot,
             const glm::vec3& side) {
    constexpr uint32_t kAround = 6;
    constexpr uint32_t kAlong = 3;
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const glm::vec3 up = glm::normalize(glm::cross(side, foot - top));
    for (uint32_t row = 0; row < kAlong; ++row) {
        const float t = static_cast<float>(row) / (kAlong - 1);
        for (uint32_t i = 0; i < kAround; ++i) {
            const auto angle = scene::builtin::sinCosTurns(0.5 * i / (kAround - 1));
            const glm::vec3 out =
                -side * static_cast<float>(angle.cos) + up * static_cast<float>(angle.sin);
            mesh.positions.push_back(glm::mix(top, foot, t) + (0.1f + 0.012f * t) * out);
        }
    }
    addGrid(mesh, first, kAround, kAlong, false);
    smoothNormals(mesh, first);
    for (uint32_t v = first; v < mesh.positions.size(); ++v)
        if (glm::dot(mesh.normals[v], up) < -0.2f) mesh.normals[v] = -mesh.normals[v];
}

/// Rows of tiles below the edge from `west` to `east`, falling by `drop` over `out`, on a board.
void addEave(assets::Mesh& mesh, const glm::vec3& from, const glm::vec3& to, const glm::vec3& out,
             float drop) {
    const glm::vec3 along = to - from;
    const auto count = static_cast<int>(glm::length(along) / 0.24f);
    const glm::vec3 side = glm::normalize(along);
    const glm::vec3 fall = out - glm::vec3(0.0f, drop, 0.0f);
    constexpr int kRows = 3;
    for (int row = 0; row < kRows; ++row) {
        for (int i = 0; i < count; ++i) {
            const glm::vec3 head =
                from + along * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count));
            const float lift = 0.02f * static_cast<float>(kRows - row);
            const glm::vec3 top =
                head + fall * (static_cast<float>(row) / kRows) + glm::vec3(0.0f, lift, 0.0f);
            addTile(mesh, top, top + fall * (1.15f / kRows), side);
        }
    }
    const glm::vec3 below(0.0f, -0.03f, 0.0f);
    const glm::vec3 thick(0.0f, -0.06f, 0.0f);
    using scene::builtin::addQuad;
    const glm::vec3 a = from + below;
    const glm::vec3 b = to + below;
    addQuad(mesh, a, a + fall, b + fall, b);
    addQuad(mesh, a + thick, b + thick, b + fall + thick, a + fall + thick);
    addQuad(mesh, a + fall, a + fall + thick, b + fall + thick, b + fall);
}

/// A window of the upper floor: a frame, two shutters of slats; faces +z of the placement.
void addShutters(assets::Mesh& mesh, const glm::mat4& placement) {
    const auto box = [&](const glm::vec3& centre, const glm::vec3& half) {
        scene::builtin::addBox(mesh, glm::translate(placement, centre), half);
    };
    box({0.0f, 0.0f, 0.0f}, {0.585f, 0.75f, 0.012f});
    for (const float side : {-1.0f, 1.0f}) {
        const float x = 0.3f * side;
        box({x - 0.25f, 0.0f, 0.04f}, {0.035f, 0.75f, 0.03f});
        box({x + 0.25f, 0.0f, 0.04f}, {0.035f, 0.75f, 0.03f});
        for (const float y : {-0.715f, 0.0f, 0.715f}) box({x, y, 0.04f}, {0.215f, 0.035f, 0.028f});
        for (int i = 0; i < 18; ++i)
            if (i != 9)
                box({x, -0.63f + 0.07f * static_cast<float>(i), 0.03f}, {0.215f, 0.024f, 0.012f});
    }
}

void addSill(assets::Mesh& mesh, const glm::mat4& placement) {
    const auto block = [&](const glm::vec3& centre, const glm::vec3& half) {
        scene::builtin::addRoundedBox(mesh, glm::translate(placement, centre),
                                      {half, 0.015f, 1, 1});
    };
    block({0.0f, -0.84f, 0.08f}, {0.78f, 0.06f, 0.12f});
    block({0.0f, 0.84f, 0.04f}, {0.74f, 0.07f, 0.08f});
    for (const float side : {-1.0f, 1.0f})
        block({0.66f * side, 0.0f, 0.03f}, {0.07f, 0.78f, 0.06f});
}

std::vector<glm::mat4> windows() {
    std::vector<glm::mat4> places;
    places.reserve(kArches + 5);
    for (int i = 0; i < kArches; ++i)
        places.push_back(placed({archWest(i) + 1.0f, 5.05f, kSquare.lower.z}));
    for (const float z : {-3.2f, 0.2f, 3.6f})
        places.push_back(placed({kSquare.lower.x, 4.4f, z}, 90.0));
    for (const float z : {-3.8f, 3.2f}) places.push_back(placed({kSquare.upper.x, 4.4f, z}, -90.0));
    return places;
}

}  // namespace

void spawnRoofs(ecs::World& world, const Paints& paints) {
    show(world, "clay tiles", paints.clay, [](assets::Mesh& mesh) {
        addEave(mesh, {-7.0f, 4.0f, -6.0f}, {7.0f, 4.0f, -6.0f}, {0.0f, 0.0f, 0.8f}, 0.4f);
        addEave(mesh, {-7.0f, kRoofY, 6.0f}, {-7.0f, kRoofY, -6.0f}, {0.6f, 0.0f, 0.0f}, 0.25f);
        addEave(mesh, {-7.0f, kRoofY, -6.0f}, {7.0f, kRoofY, -6.0f}, {0.0f, 0.0f, 0.6f}, 0.25f);
        addEave(mesh, {7.0f, kRoofY, -6.0f}, {7.0f, kRoofY, 6.0f}, {-0.6f, 0.0f, 0.0f}, 0.25f);
    });
    show(world, "shutters", paints.green, [](assets::Mesh& mesh) {
        for (const glm::mat4& place : windows()) addShutters(mesh, place);
    });
    show(world, "sills", paints.stone, [](assets::Mesh& mesh) {
        for (const glm::mat4& place : windows()) addSill(mesh, place);
    });
}

}  // namespace lampyris::courtyard
