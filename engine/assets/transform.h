/// \file Matrices taken apart.
#pragma once

#include "math/glm.h"

namespace lampyris::assets {

/// matrix = translate · rotate · scale, as near as there is one.
struct DecomposedMatrix {
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};  ///< x is negative where the matrix mirrors
    bool sheared = false;   ///< the columns are not perpendicular: the rest is lost
};

/// Takes an affine matrix apart. Axes of scale 0 take a direction perpendicular to the others.
DecomposedMatrix decompose(const glm::dmat4& matrix);

}  // namespace lampyris::assets
