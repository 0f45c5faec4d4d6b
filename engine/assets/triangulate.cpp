#include "assets/triangulate.h"

#include <cstddef>

namespace lampyris::assets {

std::vector<uint32_t> triangulate(std::vector<uint32_t> indices, Topology topology) {
    if (topology == Topology::List) {
        indices.resize(indices.size() / 3 * 3);
        return indices;
    }
    std::vector<uint32_t> triangles;
    if (indices.size() < 3) return triangles;
    triangles.reserve((indices.size() - 2) * 3);
    for (size_t i = 0; i + 2 < indices.size(); ++i) {
        if (topology == Topology::Fan)
            triangles.insert(triangles.end(), {indices[i + 1], indices[i + 2], indices[0]});
        else  // every other triangle of a strip is turned, so that all face one way
            triangles.insert(triangles.end(),
                             {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
    }
    return triangles;
}

}  // namespace lampyris::assets
