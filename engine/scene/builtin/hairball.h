/// \file A ball of curled tubes: many thin, overlapping triangles, hard on any tree.
#pragma once

#include "assets/mesh.h"

namespace lampyris::scene::builtin {

/// 2 880 000 triangles within `radiusMetres` around the origin: 2000 tubes of 180 pieces, four
/// sides each, from the middle outwards.
[[nodiscard]] assets::Mesh makeHairball(float radiusMetres);

}  // namespace lampyris::scene::builtin
