/// \file One glTF primitive as it stands in the file. Private to assets.
#pragma once

#include <optional>
#include <string>

#include "assets/gltf_source.h"

namespace lampyris::assets {

/// The triangles of a primitive with all attributes that Mesh knows, neither repaired nor
/// completed: normals may be missing, positions may be NaN. Vertices outside the indices' range are
/// left out; texture coordinates are the sets that the material reads, untransformed. Nothing where
/// there are no triangles to draw (points, lines, no positions): a warning says so. Errors: an
/// index without a vertex, attributes of unequal length or of the wrong type.
core::Result<std::optional<Mesh>> readPrimitive(GltfSource& source,
                                                const tinygltf::Primitive& primitive,
                                                const MaterialNeeds& needs,
                                                const std::string& place);

}  // namespace lampyris::assets
