#include "assets/mesh.h"

namespace lampyris::assets {

void updateBounds(Mesh& mesh) {
    mesh.bounds = {};
    for (const uint32_t index : mesh.indices) mesh.bounds.grow(mesh.positions[index]);
}

}  // namespace lampyris::assets
