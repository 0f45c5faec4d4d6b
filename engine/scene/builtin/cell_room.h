/// \file Closed rooms out of axis-aligned cells: watertight by construction.
#pragma once

#include <functional>
#include <vector>

#include "assets/mesh.h"
#include "math/glm.h"

namespace lampyris::scene::builtin {

/// A grid of cells between cuts along each axis; air where the camera and light may go.
struct CellRoom {
    std::vector<float> x;  ///< metres, increasing; one more than there are cells
    std::vector<float> y;
    std::vector<float> z;
    /// Whether a cell is air, asked with the cell's centre.
    std::function<bool(const glm::vec3& centre)> isAir;
};

/// One face between air and what is not.
struct CellFace {
    glm::vec3 centre;
    glm::vec3 normal;  ///< into the air
};

/// Appends a quad, facing the air, for every face between an air cell and a solid one or the
/// outside. `meshFor` names the mesh that takes it. All quads together are watertight: each edge
/// is shared by an even number of triangles, by two wherever no two solid cells meet in an edge.
void addCellRoom(const CellRoom& room,
                 const std::function<assets::Mesh&(const CellFace&)>& meshFor);

}  // namespace lampyris::scene::builtin
