/// \file A stone head of about a million triangles.
#pragma once

#include "assets/mesh.h"

namespace lampyris::scene::builtin {

/// A displaced sphere, closed, 1 002 252 triangles; it stands on y = 0, is 5 m high and looks
/// along +z.
[[nodiscard]] assets::Mesh makeStatue();

}  // namespace lampyris::scene::builtin
