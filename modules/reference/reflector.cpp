#include "reference/reflector.h"

#include <algorithm>

namespace lampyris::reference {
namespace {

// Neither lobe is left to chance altogether: Schlick's term grows towards grazing angles. [chosen]
constexpr float kLeastShare = 0.1f;

float mean(const glm::vec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0f;
}

}  // namespace

Reflector::Reflector(const Surface& surface, const glm::vec3& toEye, const glm::vec3& diffuseNormal,
                     bool withGloss, float clearance)
    : origin_(surface.position + clearance * surface.geometric),
      geometric_(surface.geometric),
      diffuse_(diffuseNormal),
      albedo_(surface.albedo) {
    if (!withGloss || !surface.glossy()) return;
    gloss_.emplace(surface.shading, toEye, surface.roughness, surface.f0);
    const float specular = mean(surface.f0), matt = mean(surface.albedo);
    specularShare_ = matt > 0.0f
                         ? std::clamp(specular / (specular + matt), kLeastShare, 1.0f - kLeastShare)
                         : 1.0f;
}

float Reflector::diffuseCosine(const glm::vec3& toLight) const {
    if (glm::dot(geometric_, toLight) <= 0.0f) return 0.0f;
    return std::max(glm::dot(diffuse_.normal, toLight), 0.0f);
}

glm::vec3 Reflector::specular(const glm::vec3& toLight) const {
    if (!gloss_ || glm::dot(geometric_, toLight) <= 0.0f) return glm::vec3(0.0f);
    return gloss_->timesCosine(toLight);
}

glm::vec3 Reflector::sample(const glm::vec3& xi) const {
    if (gloss_ && xi.z < specularShare_) return gloss_->sample({xi.x, xi.y});
    return diffuse_.toWorld(warpToCosine({xi.x, xi.y}));
}

float Reflector::density(const glm::vec3& toLight) const {
    const float cosine = std::max(glm::dot(diffuse_.normal, toLight), 0.0f);
    const float matt = (1.0f - specularShare_) * cosine / math::kPi;
    return gloss_ ? matt + specularShare_ * gloss_->density(toLight) : matt;
}

}  // namespace lampyris::reference
