/// \file From the unit square to directions and triangles, with the densities that result. In the
/// header, as a path spends much of its time here.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/glm.h"

namespace lampyris::reference {

/// Two unit vectors at right angles to a unit vector and to each other (Duff et al. 2017).
struct Frame {
    explicit Frame(const glm::vec3& n) : normal(n) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        tangent = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
        bitangent = {b, sign + n.y * n.y * a, -n.y};
    }
    [[nodiscard]] glm::vec3 toWorld(const glm::vec3& local) const {
        return local.x * tangent + local.y * bitangent + local.z * normal;
    }
    [[nodiscard]] glm::vec3 toLocal(const glm::vec3& world) const {
        return {glm::dot(world, tangent), glm::dot(world, bitangent), glm::dot(world, normal)};
    }
    glm::vec3 tangent, bitangent, normal;
};

/// Cosine and sine of a share of the full turn, from 0 to 1: half an ulp or two from the library's,
/// and a tenth of a path's time less.
[[nodiscard]] inline glm::vec2 turned(float share) {
    const int quarter = (static_cast<int>(8.0f * share) + 1) / 2;  // the nearest
    const float x = (share - 0.25f * static_cast<float>(quarter)) * (2.0f * math::kPi);  // ±π/4
    const float x2 = x * x;
    // Minimax polynomials of the Cephes library (Moshier 1989).
    const float sine =
        x + x * x2 * (-1.6666654611e-1f + x2 * (8.3321608736e-3f - x2 * 1.9515295891e-4f));
    const float cosine =
        1.0f - 0.5f * x2 +
        x2 * x2 *
            (4.166664568298827e-2f + x2 * (-1.388731625493765e-3f + x2 * 2.443315711809948e-5f));
    const glm::vec2 first = (quarter & 1) != 0 ? glm::vec2(-sine, cosine) : glm::vec2(cosine, sine);
    return (quarter & 2) != 0 ? -first : first;
}

/// Uniform on the unit disk; neighbours stay neighbours (Shirley and Chiu 1997).
[[nodiscard]] inline glm::vec2 warpToDisk(glm::vec2 xi) {
    const glm::vec2 p = 2.0f * xi - 1.0f;
    if (p.x == 0.0f && p.y == 0.0f) return {0.0f, 0.0f};
    constexpr float kEighth = math::kPi / 4.0f;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float radius = wide ? p.x : p.y;
    const float angle = wide ? kEighth * (p.y / p.x) : 2.0f * kEighth - kEighth * (p.x / p.y);
    return radius * glm::vec2(std::cos(angle), std::sin(angle));
}

/// Uniform in the cone about +z: density 1 / (2π · oneMinusCos). `oneMinusCos` is 1 less the cosine
/// of the half-angle: cones may be so narrow that the cosine itself rounds to 1.
[[nodiscard]] inline glm::vec3 warpToCone(glm::vec2 xi, float oneMinusCos) {
    const float below = xi.x * oneMinusCos;  // 1 − cos θ
    const float sine = std::sqrt(std::max(0.0f, below * (2.0f - below)));
    return {sine * turned(xi.y), 1.0f - below};
}

/// Uniform over the unit sphere: density 1 / 4π.
[[nodiscard]] inline glm::vec3 warpToSphere(glm::vec2 xi) {
    return warpToCone(xi, 2.0f);
}

/// About a unit normal with density cos θ / π a steradian: a chord of the unit sphere from its
/// lowest point to a uniform one needs no frame.
[[nodiscard]] inline glm::vec3 warpToCosine(glm::vec2 xi, const glm::vec3& normal) {
    const glm::vec3 chord = normal + warpToSphere(xi);
    const float length2 = glm::dot(chord, chord);
    return length2 > 1e-12f ? chord * (1.0f / std::sqrt(length2)) : normal;
}

/// Weights of the second and third corner, uniform over a triangle.
[[nodiscard]] inline glm::vec2 warpToTriangle(glm::vec2 xi) {
    const float root = std::sqrt(xi.x);
    return {root * (1.0f - xi.y), root * xi.y};
}

/// Share of an estimate whose direction was drawn with density `own`, where another technique
/// would have drawn it with `other` (power heuristic, Veach 1997).
[[nodiscard]] inline float powerHeuristic(float own, float other) {
    if (!(own > 0.0f)) return 0.0f;
    const float ratio = other / own;
    return 1.0f / (1.0f + ratio * ratio);
}

}  // namespace lampyris::reference
