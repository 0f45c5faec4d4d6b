#include "reference/warps.h"

#include <cmath>

namespace lampyris::reference {

Frame::Frame(const glm::vec3& n) : normal(n) {
    const glm::vec3 aside =
        std::abs(n.x) < 0.6f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    tangent = glm::normalize(glm::cross(aside, n));
    bitangent = glm::cross(n, tangent);
}

glm::vec2 warpToDisk(glm::vec2 xi) {
    const glm::vec2 p = 2.0f * xi - 1.0f;
    if (p.x == 0.0f && p.y == 0.0f) return {0.0f, 0.0f};
    constexpr float kQuarter = math::kPi / 4.0f;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float radius = wide ? p.x : p.y;
    const float angle = wide ? kQuarter * (p.y / p.x) : 2.0f * kQuarter - kQuarter * (p.x / p.y);
    return radius * glm::vec2(std::cos(angle), std::sin(angle));
}

glm::vec3 warpToCosine(glm::vec2 xi) {
    const glm::vec2 disk = warpToDisk(xi);
    return {disk, std::sqrt(std::max(0.0f, 1.0f - glm::dot(disk, disk)))};
}

glm::vec3 warpToSphere(glm::vec2 xi) {
    return warpToCone(xi, 2.0f);
}

glm::vec3 warpToCone(glm::vec2 xi, float oneMinusCos) {
    const float below = xi.x * oneMinusCos;  // 1 − cos θ
    const float sine = std::sqrt(std::max(0.0f, below * (2.0f - below)));
    const float phi = 2.0f * math::kPi * xi.y;
    return {sine * std::cos(phi), sine * std::sin(phi), 1.0f - below};
}

glm::vec2 warpToTriangle(glm::vec2 xi) {
    const float root = std::sqrt(xi.x);
    return {root * (1.0f - xi.y), root * xi.y};
}

}  // namespace lampyris::reference
