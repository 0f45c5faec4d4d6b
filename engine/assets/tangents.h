/// \file Tangents from texture coordinates.
#pragma once

#include <cstdint>

#include "assets/mesh.h"

namespace lampyris::assets {

/// Fills Mesh::tangents from the given texture coordinate set (0 or 1), which the mesh must have.
/// A vertex's tangent is the mean of its triangles', weighted by their angle there, made
/// perpendicular to the normal. As glTF wants it, w · cross(normal, tangent) points up the image,
/// against v. Where the coordinates do not vary, any perpendicular serves.
void generateTangents(Mesh& mesh, uint32_t texcoordSet);

/// Makes given tangents unit and their w 1 or −1; one without a direction becomes any
/// perpendicular.
void normalizeTangents(Mesh& mesh);

}  // namespace lampyris::assets
