/// \file What a mesh from outside needs before it can be drawn: broken triangles out, normals in.
#pragma once

#include <cstdint>
#include <vector>

#include "assets/mesh.h"

namespace lampyris::assets {

/// Triangles that were taken out.
struct DroppedTriangles {
    uint32_t nonFinite = 0;  ///< a vertex at NaN or infinity
    uint32_t zeroArea = 0;   ///< thinner than 1e-7 of their longest edge: below a float's precision
};

/// Takes out triangles that cannot be drawn. A morphed mesh keeps those without area, unless two of
/// their corners are one vertex: its targets may open them.
DroppedTriangles dropBrokenTriangles(Mesh& mesh);

/// The mesh with vertex i where vertices[i] was, in all attributes; indices are left to the caller.
void gatherVertices(Mesh& mesh, const std::vector<uint32_t>& vertices);

/// Drops the vertices that no triangle uses.
void dropUnusedVertices(Mesh& mesh);

/// Gives every corner its own vertex and the normal of its face.
void makeFlatNormals(Mesh& mesh);

/// Makes every normal unit; one that is zero or not finite becomes that of a face at its vertex.
/// Gives the number of those.
uint32_t normalizeNormals(Mesh& mesh);

/// Sets what is not finite in the optional attributes to zero; gives the number of vertices
/// changed.
uint32_t zeroNonFinite(Mesh& mesh);

}  // namespace lampyris::assets
