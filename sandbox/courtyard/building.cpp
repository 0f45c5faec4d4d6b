#include "courtyard/building.h"

#include <algorithm>
#include <array>

#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "scene/builtin/cell_room.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {

using scene::builtin::CellFace;
using scene::builtin::CellRoom;
using scene::builtin::placed;

std::vector<Room> rooms() {
    std::vector<Room> all{kSquare, kArcade,    kWorkshop, kStudy, kStreet,    kDoorway,
                          kWindow, kStudyDoor, kPassage,  kGate,  kStreetDoor};
    for (int i = 0; i < kArches; ++i)
        all.push_back({{archWest(i), 0.0f, -6.4f}, {archWest(i) + kArchWidth, kArchTopY, -6.0f}});
    return all;
}

float floorAt(const glm::vec3& position) {
    const auto above = [&](const Room& room) {
        return position.x > room.lower.x && position.x < room.upper.x &&
               position.z > room.lower.z && position.z < room.upper.z;
    };
    return above(kSquare) || above(kStreet) ? kSlabTopY : 0.0f;
}

namespace {

std::vector<float> cutsAlong(const std::vector<Room>& all, int axis) {
    std::vector<float> cuts;
    for (const Room& room : all) {
        cuts.push_back(room.lower[axis]);
        cuts.push_back(room.upper[axis]);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

bool holds(const Room& room, const glm::vec3& point) {
    return glm::all(glm::lessThan(room.lower, point)) && glm::all(glm::lessThan(point, room.upper));
}

struct Shell {
    assets::Mesh plaster, red, teal, blue, ceiling, floor, sky;

    assets::Mesh& meshFor(const CellFace& face) {
        const glm::vec3& at = face.centre;
        if (face.normal.y > 0.5f) return floor;
        if (face.normal.y < -0.5f) return at.y > kCeilingY ? sky : ceiling;
        if (face.normal.x > 0.5f && at.x == kSquare.lower.x && at.z > kSquare.lower.z) return red;
        if (at.z == kArcade.lower.z && at.x > kArcade.lower.x && at.x < kArcade.upper.x)
            return teal;
        const bool inStudy = at.x < kStudyDoor.lower.x + 0.01f && at.z < kStudy.upper.z + 0.01f;
        return inStudy ? blue : plaster;
    }
};

void spawnShell(ecs::World& world, const Paints& paints) {
    const std::vector<Room> all = rooms();
    const CellRoom cells{
        cutsAlong(all, 0), cutsAlong(all, 1), cutsAlong(all, 2), [&](const glm::vec3& centre) {
            return std::any_of(all.begin(), all.end(),
                               [&](const Room& room) { return holds(room, centre); });
        }};
    Shell shell;
    addCellRoom(cells, [&](const CellFace& face) -> assets::Mesh& { return shell.meshFor(face); });
    const auto add = [&](const char* name, scene::MaterialId paint, assets::Mesh& mesh) {
        show(world, name, paint, [&](assets::Mesh& shown) {
            shown = std::move(mesh);
            shown.name = name;
        });
    };
    add("walls", paints.plaster, shell.plaster);
    add("west wall", paints.red, shell.red);
    add("arcade's wall", paints.teal, shell.teal);
    add("study's walls", paints.blue, shell.blue);
    add("ceilings", paints.ceiling, shell.ceiling);
    add("floors", paints.tiles, shell.floor);
}

/// A column of the arcade in front of a pier, 32 · 2 · steps triangles.
void addColumn(assets::Mesh& mesh, const glm::vec3& foot) {
    std::vector<glm::vec2> profile{{0.24f, 0.0f},  {0.24f, 0.1f},   {0.24f, 0.1f},  {0.2f, 0.1f},
                                   {0.2f, 0.1f},   {0.215f, 0.13f}, {0.22f, 0.16f}, {0.215f, 0.19f},
                                   {0.19f, 0.22f}, {0.165f, 0.24f}};
    constexpr int kSteps = 12;
    for (int i = 0; i <= kSteps; ++i) {  // the shaft swells a little
        const float t = static_cast<float>(i) / kSteps;
        profile.emplace_back(0.165f - 0.03f * t * t, 0.24f + 1.76f * t);
    }
    const std::array<glm::vec2, 10> capital{{{0.135f, 2.0f},
                                             {0.16f, 2.0f},
                                             {0.17f, 2.03f},
                                             {0.16f, 2.06f},
                                             {0.15f, 2.06f},
                                             {0.16f, 2.12f},
                                             {0.19f, 2.18f},
                                             {0.25f, 2.22f},
                                             {0.25f, 2.22f},
                                             {0.25f, 2.3f}}};
    profile.insert(profile.end(), capital.begin(), capital.end());
    profile.insert(profile.end(), {{0.25f, 2.3f}, {0.001f, 2.3f}});
    addLathe(mesh, placed(foot), profile, 28);
}

/// Bent along the edge of an arch.
void addMoulding(assets::Mesh& mesh, const glm::vec3& springCentre, float radius) {
    std::array<glm::vec3, 41> path;
    for (size_t i = 0; i < path.size(); ++i) {
        const auto angle = scene::builtin::sinCosTurns(0.5 * static_cast<double>(i) / 40.0);
        path[i] = springCentre + radius * glm::vec3(static_cast<float>(angle.cos),
                                                    static_cast<float>(angle.sin), 0.0f);
    }
    scene::builtin::addTube(mesh, path, 0.055f, 12);
}

void spawnArcade(ecs::World& world, const Paints& paints) {
    show(world, "arches", paints.stone, [](assets::Mesh& mesh) {
        for (int i = 0; i < kArches; ++i) {
            const float x = archWest(i) + 0.5f * kArchWidth;
            addArch(mesh, placed({x, 0.0f, -6.2f}), {kArchWidth + 0.04f, kArchTopY + 0.02f, 0.42f});
            addMoulding(mesh, {x, kArchTopY - 1.02f, -5.97f}, 1.04f);
        }
        addArch(mesh, placed({7.2f, 0.0f, -0.4f}, 90.0), {2.44f, kArchTopY + 0.02f, 0.42f});
    });
    show(world, "columns", paints.stone, [](assets::Mesh& mesh) {
        for (int i = 0; i <= kArches; ++i) {
            const float x = archWest(i) - 0.4f;
            addColumn(mesh, {glm::clamp(x, -6.74f, 6.74f), 0.0f, -5.74f});
            addBlock(mesh, {x - 0.45f, 2.3f, -6.45f}, {x + 0.45f, 2.4f, -5.46f});
        }
    });
    show(world, "string course", paints.stone, [](assets::Mesh& mesh) {
        addBlock(mesh, {-7.05f, 3.2f, -6.1f}, {7.05f, 3.34f, -5.86f});
    });
}

}  // namespace

void spawnBuilding(ecs::World& world, const Paints& paints) {
    spawnShell(world, paints);
    spawnArcade(world, paints);
}

}  // namespace lampyris::courtyard
