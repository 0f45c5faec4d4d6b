/// \file What an animation's keys say of a time between them [glTF 2.0, appendix C].
#pragma once

#include <span>

#include "assets/animation.h"
#include "math/glm.h"

namespace lampyris::assets {

// Before the first key its value holds, after the last key its; a NaN time is before. The result is
// finite: where keys that are too far apart leave a float's range, the key before stands in.

/// Numbers that do not belong together; `values` is as long as the sampler's components.
void sampleNumbers(const AnimationSampler& sampler, double seconds, std::span<float> values);
/// Of translation and scale: a sampler of three components.
[[nodiscard]] glm::vec3 sampleVector(const AnimationSampler& sampler, double seconds);
/// Unit; the shorter way round between two linear keys. A sampler of four components. Keys without
/// a direction count as no rotation.
[[nodiscard]] glm::quat sampleRotation(const AnimationSampler& sampler, double seconds);

}  // namespace lampyris::assets
