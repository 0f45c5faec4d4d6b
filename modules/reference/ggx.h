/// \file Glossy reflection as the G-buffer's model has it [R3].
#pragma once

#include "math/glm.h"
#include "reference/warps.h"

namespace lampyris::reference {

/// Trowbridge–Reitz with Smith–Schlick shadowing and Schlick's Fresnel term, at one point seen from
/// one direction. Directions are unit, in world space, and point away from the surface.
class Ggx {
 public:
    /// `roughness` is the material's; its square is the distribution's width.
    Ggx(const glm::vec3& normal, const glm::vec3& toEye, float roughness, const glm::vec3& f0);

    /// BRDF · cosine, 1/sr.
    [[nodiscard]] glm::vec3 timesCosine(const glm::vec3& toLight) const;
    /// Density a steradian with which sample() gives this direction.
    [[nodiscard]] float density(const glm::vec3& toLight) const;
    /// Draws a visible normal (Heitz 2018) and reflects; may point below the surface.
    [[nodiscard]] glm::vec3 sample(glm::vec2 xi) const;

 private:
    [[nodiscard]] float distribution(float sine2, float cosine) const;

    Frame frame_;
    glm::vec3 toEye_;
    glm::vec3 visibleFrom_;  ///< toEye in the frame, lifted to the horizon
    glm::vec3 f0_;
    float alpha_, k_;
};

}  // namespace lampyris::reference
