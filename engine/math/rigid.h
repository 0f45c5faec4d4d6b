/// \file Rigid motions out of transforms that also scale and shear.
#pragma once

#include "math/glm.h"

namespace lampyris::math {

/// Where a transform puts its origin and which way it turns: unit axes at right angles,
/// right-handed, along the same z; without a turn where the matrix's y and z have no cross product.
[[nodiscard]] inline glm::mat4 rigidPart(const glm::mat4& matrix) {
    // In double: the squares of tiny scales are zero in float.
    const glm::dvec3 back(matrix[2]);
    const glm::dvec3 right = glm::cross(glm::dvec3(matrix[1]), back);
    glm::mat4 rigid(1.0f);
    if (glm::dot(right, right) > 0.0) {
        const glm::dvec3 x = glm::normalize(right);
        const glm::dvec3 z = glm::normalize(back);
        rigid[0] = glm::vec4(glm::vec3(x), 0.0f);
        rigid[1] = glm::vec4(glm::vec3(glm::cross(z, x)), 0.0f);
        rigid[2] = glm::vec4(glm::vec3(z), 0.0f);
    }
    rigid[3] = matrix[3];
    return rigid;
}

}  // namespace lampyris::math
