/// \file Lanterns: a cage of bars around a light.
#pragma once

#include "assets/mesh.h"

namespace lampyris::courtyard {

/// A cage of six bars with a roof and a ring above, around the origin, 0.2 m wide and 0.4 m high.
void addLanternCage(assets::Mesh& mesh, const glm::mat4& placement);

}  // namespace lampyris::courtyard
