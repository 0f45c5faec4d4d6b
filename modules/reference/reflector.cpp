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

}  // namespace lampyris::reference
