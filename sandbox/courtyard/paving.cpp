// The floor of the square: slabs with bevelled edges, each a little higher or lower.
#include "courtyard/building.h"
#include "courtyard/floor_plan.h"
#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {
namespace {

constexpr float kBevelMetres = 0.025f;

/// Top and four bevels; it stands in the floor, so that nothing shows below.
void addSlab(assets::Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float topY) {
    using scene::builtin::addQuad;
    const auto outer = [&](bool east, bool south) {
        return glm::vec3(east ? upper.x : lower.x, -0.01f, south ? upper.y : lower.y);
    };
    const auto inner = [&](bool east, bool south) {
        const float inset = kBevelMetres;
        return glm::vec3(east ? upper.x - inset : lower.x + inset, topY,
                         south ? upper.y - inset : lower.y + inset);
    };
    addQuad(mesh, inner(false, true), inner(true, true), inner(true, false), inner(false, false));
    addQuad(mesh, outer(false, true), outer(true, true), inner(true, true), inner(false, true));
    addQuad(mesh, outer(true, true), outer(true, false), inner(true, false), inner(true, true));
    addQuad(mesh, outer(true, false), outer(false, false), inner(false, false), inner(true, false));
    addQuad(mesh, outer(false, false), outer(false, true), inner(false, true), inner(false, false));
}

/// Rows of slabs, every other row set off by half a slab.
void addSlabs(assets::Mesh& mesh, const Room& room, float size) {
    uint32_t number = 0;
    float z = room.lower.z;
    for (int row = 0; z < room.upper.z - 0.1f; ++row) {
        float west = room.lower.x;
        float east = west + (row % 2 == 0 ? size : 0.5f * size);
        while (west < room.upper.x - 0.01f) {
            const float end = glm::min(east, room.upper.x);
            const float topY = 0.02f + 0.012f * scene::builtin::hashUnit(77, number++);
            addSlab(mesh, {west, z}, {end, glm::min(z + size, room.upper.z)}, topY);
            west = end;
            east = end + size;
        }
        z += size;
    }
}

}  // namespace

void spawnPaving(ecs::World& world, const Paints& paints) {
    show(world, "slabs", paints.slabs, [](assets::Mesh& mesh) {
        addSlabs(mesh, kSquare, 0.6f);
        addSlabs(mesh, kStreet, 0.5f);
    });
}

}  // namespace lampyris::courtyard
