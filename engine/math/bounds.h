/// \file Axis-aligned bounds.
#pragma once

#include <limits>

#include "math/glm.h"

namespace lampyris::math {

/// Axis-aligned box; the default is empty (lower above upper).
struct Bounds {
    glm::vec3 lower{std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};

    [[nodiscard]] bool empty() const {
        return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z;
    }
    [[nodiscard]] glm::vec3 centre() const { return 0.5f * (lower + upper); }
    [[nodiscard]] glm::vec3 extent() const { return empty() ? glm::vec3(0.0f) : upper - lower; }
    /// Half the surface area, m².
    [[nodiscard]] float halfArea() const {
        const glm::vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }

    void grow(const glm::vec3& point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
    void grow(const Bounds& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
};

/// The smallest box around the eight transformed corners.
inline Bounds transformed(const Bounds& bounds, const glm::mat4& matrix) {
    Bounds result;
    if (bounds.empty()) return result;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                              (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                              (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z);
        result.grow(glm::vec3(matrix * glm::vec4(point, 1.0f)));
    }
    return result;
}

}  // namespace lampyris::math
