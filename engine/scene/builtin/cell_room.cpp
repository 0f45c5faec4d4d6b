#include "scene/builtin/cell_room.h"

#include "scene/builtin/shapes.h"

namespace lampyris::scene::builtin {

namespace {

struct Cell {
    glm::vec3 lower;
    glm::vec3 upper;
};

Cell cellAt(const CellRoom& room, const glm::ivec3& i) {
    return {{room.x[i.x], room.y[i.y], room.z[i.z]},
            {room.x[i.x + 1], room.y[i.y + 1], room.z[i.z + 1]}};
}

bool isAirAt(const CellRoom& room, const glm::ivec3& count, const glm::ivec3& i) {
    for (int axis = 0; axis < 3; ++axis) {
        if (i[axis] < 0 || i[axis] >= count[axis]) return false;
    }
    const Cell cell = cellAt(room, i);
    return room.isAir(0.5f * (cell.lower + cell.upper));
}

void addFace(const Cell& cell, int axis, int side,
             const std::function<assets::Mesh&(const CellFace&)>& meshFor) {
    const auto at = [&](bool u, bool v) {
        glm::vec3 p;
        p[axis] = side > 0 ? cell.upper[axis] : cell.lower[axis];
        p[(axis + 1) % 3] = u ? cell.upper[(axis + 1) % 3] : cell.lower[(axis + 1) % 3];
        p[(axis + 2) % 3] = v ? cell.upper[(axis + 2) % 3] : cell.lower[(axis + 2) % 3];
        return p;
    };
    CellFace face{0.5f * (at(false, false) + at(true, true)), glm::vec3(0.0f)};
    face.normal[axis] = static_cast<float>(-side);
    const bool flip = side > 0;
    addQuad(meshFor(face), at(false, false), at(!flip, flip), at(true, true), at(flip, !flip));
}

}  // namespace

void addCellRoom(const CellRoom& room,
                 const std::function<assets::Mesh&(const CellFace&)>& meshFor) {
    const glm::ivec3 count(static_cast<int>(room.x.size()) - 1, static_cast<int>(room.y.size()) - 1,
                           static_cast<int>(room.z.size()) - 1);
    glm::ivec3 i;
    for (i.z = 0; i.z < count.z; ++i.z) {
        for (i.y = 0; i.y < count.y; ++i.y) {
            for (i.x = 0; i.x < count.x; ++i.x) {
                if (!isAirAt(room, count, i)) continue;
                for (int axis = 0; axis < 3; ++axis) {
                    for (const int side : {-1, 1}) {
                        glm::ivec3 neighbour = i;
                        neighbour[axis] += side;
                        if (isAirAt(room, count, neighbour)) continue;
                        addFace(cellAt(room, i), axis, side, meshFor);
                    }
                }
            }
        }
    }
}

}  // namespace lampyris::scene::builtin
