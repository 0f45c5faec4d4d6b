#include "assets/transform.h"

#include <cmath>
#include <limits>

namespace lampyris::assets {
namespace {

constexpr double kPerpendicular = 1e-3;  // [chosen] cosine; exporters write six digits

/// Unit axes: the first kept, the others made perpendicular to those before (Gram–Schmidt).
glm::dmat3 orthonormal(glm::dmat3 axes) {
    const glm::dmat3 spares(1.0);
    for (int i = 0; i < 3; ++i) {
        const auto withoutEarlier = [&](glm::dvec3 axis) {
            for (int j = 0; j < i; ++j) axis -= axes[j] * glm::dot(axis, axes[j]);
            return axis;
        };
        glm::dvec3 axis = withoutEarlier(axes[i]);
        for (int s = 0; s < 3 && glm::length(axis) < kPerpendicular; ++s)
            axis = withoutEarlier(spares[(i + s) % 3]);
        axes[i] = glm::normalize(axis);
    }
    return axes;
}

}  // namespace

DecomposedMatrix decompose(const glm::dmat4& matrix) {
    DecomposedMatrix parts;
    parts.translation = glm::vec3(matrix[3]);
    glm::dmat3 axes(matrix);
    glm::dvec3 scale(0.0);
    for (int i = 0; i < 3; ++i) {
        scale[i] = glm::length(axes[i]);
        axes[i] = scale[i] > 0.0 ? axes[i] / scale[i] : glm::dvec3(0.0);
    }
    for (int i = 0; i < 3; ++i)
        if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > kPerpendicular) parts.sheared = true;
    if (glm::determinant(axes) < 0.0) {
        scale.x = -scale.x;
        axes[0] = -axes[0];
    }
    axes = orthonormal(axes);
    if (glm::determinant(axes) < 0.0) axes[2] = -axes[2];  // only where a scale is 0
    parts.rotation = glm::quat(glm::quat_cast(axes));
    constexpr double kLargest = std::numeric_limits<float>::max();
    parts.scale = glm::vec3(glm::clamp(scale, -kLargest, kLargest));
    return parts;
}

}  // namespace lampyris::assets
