/// \file From the unit square to directions and triangles, with the densities that result.
#pragma once

#include "math/glm.h"

namespace lampyris::reference {

/// Two unit vectors at right angles to a unit vector and to each other.
struct Frame {
    explicit Frame(const glm::vec3& normal);
    [[nodiscard]] glm::vec3 toWorld(const glm::vec3& local) const {
        return local.x * tangent + local.y * bitangent + local.z * normal;
    }
    [[nodiscard]] glm::vec3 toLocal(const glm::vec3& world) const {
        return {glm::dot(world, tangent), glm::dot(world, bitangent), glm::dot(world, normal)};
    }
    glm::vec3 tangent, bitangent, normal;
};

/// Uniform on the unit disk; neighbours stay neighbours (Shirley and Chiu 1997).
[[nodiscard]] glm::vec2 warpToDisk(glm::vec2 xi);

/// About +z with density cos θ / π a steradian.
[[nodiscard]] glm::vec3 warpToCosine(glm::vec2 xi);

/// Uniform over the unit sphere: density 1 / 4π.
[[nodiscard]] glm::vec3 warpToSphere(glm::vec2 xi);

/// Uniform in the cone about +z: density 1 / (2π · oneMinusCos). `oneMinusCos` is 1 less the cosine
/// of the half-angle: cones may be so narrow that the cosine itself rounds to 1.
[[nodiscard]] glm::vec3 warpToCone(glm::vec2 xi, float oneMinusCos);

/// Weights of the second and third corner, uniform over a triangle.
[[nodiscard]] glm::vec2 warpToTriangle(glm::vec2 xi);

/// Share of an estimate whose direction was drawn with density `own`, where another technique
/// would have drawn it with `other` (power heuristic, Veach 1997).
[[nodiscard]] inline float powerHeuristic(float own, float other) {
    if (!(own > 0.0f)) return 0.0f;
    const float ratio = other / own;
    return 1.0f / (1.0f + ratio * ratio);
}

}  // namespace lampyris::reference
