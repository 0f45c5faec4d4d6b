/// \file A surface seen from one direction: how it reflects, and where its paths go.
#pragma once

#include <algorithm>
#include <optional>

#include "reference/ggx.h"
#include "reference/surface.h"

namespace lampyris::reference {

/// Lambert about one normal, and GGX about the shading normal where it is glossy. Nothing comes
/// from below the geometric surface. Directions are unit and point away from the surface.
class Reflector {
 public:
    /// Rays leave `clearance` metres above the surface.
    Reflector(const Surface& surface, const glm::vec3& toEye, const glm::vec3& diffuseNormal,
              bool withGloss, float clearance);

    [[nodiscard]] const glm::vec3& origin() const { return origin_; }
    [[nodiscard]] const glm::vec3& geometricNormal() const { return geometric_; }
    [[nodiscard]] const glm::vec3& albedo() const { return albedo_; }
    [[nodiscard]] const std::optional<Ggx>& gloss() const { return gloss_; }

    /// Cosine to the diffuse normal; 0 from below. Times albedo/π it is BRDF · cosine.
    [[nodiscard]] float diffuseCosine(const glm::vec3& toLight) const {
        if (glm::dot(geometric_, toLight) <= 0.0f) return 0.0f;
        return std::max(glm::dot(diffuse_, toLight), 0.0f);
    }
    /// GGX · cosine, 1/sr; 0 from below.
    [[nodiscard]] glm::vec3 specular(const glm::vec3& toLight) const {
        if (!gloss_ || glm::dot(geometric_, toLight) <= 0.0f) return glm::vec3(0.0f);
        return gloss_->timesCosine(toLight);
    }

    /// A direction for a path to go on, from both lobes.
    [[nodiscard]] glm::vec3 sample(const glm::vec3& xi) const {
        if (gloss_ && xi.z < specularShare_) return gloss_->sample({xi.x, xi.y});
        return warpToCosine({xi.x, xi.y}, diffuse_);
    }
    /// Density a steradian of sample().
    [[nodiscard]] float density(const glm::vec3& toLight) const {
        const float cosine = std::max(glm::dot(diffuse_, toLight), 0.0f);
        const float matt = (1.0f - specularShare_) * cosine / math::kPi;
        return gloss_ ? matt + specularShare_ * gloss_->density(toLight) : matt;
    }

 private:
    glm::vec3 origin_, geometric_, diffuse_, albedo_;
    std::optional<Ggx> gloss_;
    float specularShare_ = 0.0f;  ///< of the directions that sample() draws
};

}  // namespace lampyris::reference
