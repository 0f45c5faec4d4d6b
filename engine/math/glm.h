/// \file GLM as the project uses it: radians, clip depth from 0 to 1. Include this, not <glm/…>.
#pragma once

#include <glm/ext/matrix_transform.hpp>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/quaternion.hpp>

namespace lampyris::math {

constexpr float kPi = 3.14159265358979323846f;

/// Right-handed perspective, reversed depth: the near plane at 1, infinity at 0, y down in clip
/// space (Vulkan).
inline glm::mat4 perspectiveReversed(float verticalFovRadians, float aspect, float nearMetres) {
    const float f = 1.0f / std::tan(0.5f * verticalFovRadians);
    glm::mat4 m(0.0f);
    m[0][0] = f / aspect;
    m[1][1] = -f;
    m[2][3] = -1.0f;
    m[3][2] = nearMetres;
    return m;
}

}  // namespace lampyris::math
