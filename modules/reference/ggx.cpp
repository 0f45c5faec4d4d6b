#include "reference/ggx.h"

#include <algorithm>
#include <cmath>

namespace lampyris::reference {
namespace {

// As the G-buffer's model: no mirror is perfect, and no eye lies in the surface.
constexpr float kLeastRoughness = 0.03f;
constexpr float kLeastCosine = 1e-4f;

float fifthPower(float x) {
    return (x * x) * (x * x) * x;
}

/// Zero between opposite directions.
glm::vec3 halfway(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 sum = a + b;
    const float length2 = glm::dot(sum, sum);
    return length2 > 0.0f ? sum / std::sqrt(length2) : glm::vec3(0.0f);
}

glm::vec3 lifted(const glm::vec3& local) {
    return glm::normalize(glm::vec3(local.x, local.y, std::max(local.z, kLeastCosine)));
}

}  // namespace

Ggx::Ggx(const glm::vec3& normal, const glm::vec3& toEye, float roughness, const glm::vec3& f0)
    : frame_(normal),
      toEye_(toEye),
      visibleFrom_(lifted(frame_.toLocal(toEye))),
      f0_(f0),
      alpha_(std::max(roughness, kLeastRoughness) * std::max(roughness, kLeastRoughness)),
      k_((roughness + 1.0f) * (roughness + 1.0f) / 8.0f) {}

float Ggx::distribution(float sine2, float cosine) const {
    const float alpha2 = alpha_ * alpha_;
    // cos²·(α² − 1) + 1, without taking nearly equal numbers from each other.
    const float d = sine2 + cosine * cosine * alpha2;
    return alpha2 / (math::kPi * d * d);
}

glm::vec3 Ggx::timesCosine(const glm::vec3& toLight) const {
    const float nl = glm::dot(frame_.normal, toLight);
    if (nl <= 0.0f) return glm::vec3(0.0f);
    const float nv = std::max(glm::dot(frame_.normal, toEye_), kLeastCosine);
    const glm::vec3 half = halfway(toEye_, toLight);
    const float nh = std::max(glm::dot(frame_.normal, half), 0.0f);
    const glm::vec3 across = glm::cross(frame_.normal, half);
    const float d = distribution(nh > 0.0f ? glm::dot(across, across) : 1.0f, nh);
    const float smith = (nl / (nl * (1.0f - k_) + k_)) * (nv / (nv * (1.0f - k_) + k_));
    const float vh = std::clamp(glm::dot(toEye_, half), 0.0f, 1.0f);
    const glm::vec3 fresnel = f0_ + (1.0f - f0_) * fifthPower(1.0f - vh);
    return fresnel * (d * smith / (4.0f * nv));
}

float Ggx::density(const glm::vec3& toLight) const {
    const glm::vec3 half = halfway(toEye_, toLight);
    const glm::vec3 h = frame_.toLocal(half);
    const float vh = glm::dot(toEye_, half);
    if (h.z <= 0.0f || vh <= 0.0f) return 0.0f;
    const glm::vec3& v = visibleFrom_;
    const float slope2 = alpha_ * alpha_ * (v.x * v.x + v.y * v.y) / (v.z * v.z);
    const float seen = 2.0f / (1.0f + std::sqrt(1.0f + slope2));
    const float normals =
        seen * std::max(glm::dot(v, h), 0.0f) * distribution(h.x * h.x + h.y * h.y, h.z) / v.z;
    return normals / (4.0f * vh);
}

glm::vec3 Ggx::sample(glm::vec2 xi) const {
    const glm::vec3 stretched =
        glm::normalize(glm::vec3(alpha_ * visibleFrom_.x, alpha_ * visibleFrom_.y, visibleFrom_.z));
    glm::vec2 disk = warpToDisk(xi);
    // The tangent must lie in the plane of the stretched surface: that half of the disk is seen
    // whole, the other foreshortened.
    const float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
    const glm::vec3 t1 = length2 > 0.0f
                             ? glm::vec3(-stretched.y, stretched.x, 0.0f) / std::sqrt(length2)
                             : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 t2 = glm::cross(stretched, t1);
    const float s = 0.5f * (1.0f + stretched.z);
    disk.y = (1.0f - s) * std::sqrt(std::max(0.0f, 1.0f - disk.x * disk.x)) + s * disk.y;
    const float out = std::sqrt(std::max(0.0f, 1.0f - glm::dot(disk, disk)));
    const glm::vec3 n = disk.x * t1 + disk.y * t2 + out * stretched;
    const glm::vec3 half =
        frame_.toWorld(glm::normalize(glm::vec3(alpha_ * n.x, alpha_ * n.y, std::max(n.z, 0.0f))));
    return 2.0f * glm::dot(toEye_, half) * half - toEye_;
}

}  // namespace lampyris::reference
