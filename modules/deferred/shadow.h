/// \file shadow: at low resolution, how much of each light that reaches the texel a few rays see.
///   in      surface, light lists, BVH       out   shares, and where each texel stands
///   shader  deferred/shadow.comp, shadow_penumbra.comp       theory  README [D4], [D7]
#pragma once

#include "accel/accel_on_gpu.h"
#include "core/result.h"
#include "deferred/light_lists.h"

namespace lampyris::deferred {

struct ShadowSettings {
    uint32_t divisor;  ///< low resolution, an axis
    uint32_t rays;     ///< a texel and light, from 1 to 31
    uint32_t seed;     ///< of this frame
};

struct Shadows {
    /// R32Uint, SHARE_PLANES layers for 32 lights: layer k holds bit k of the share of each that is
    /// seen, in SHARE_WHOLEths.
    graph::Image shares{};
    graph::Image guide{};  ///< RGBA32Uint: position as float bits, normal octahedral
    shared::DirectParams params{};
};

/// Whether the shares of so many lights fit the layers that the device's images may have.
core::Result<void> checkShadowCounts(uint32_t lights, uint32_t maxImageArrayLayers);

[[nodiscard]] Shadows addShadow(graph::Frame& frame, const Surface& surface,
                                const LightLists& lights, const residency::SceneHandles& scene,
                                const accel::AccelHandles& accel, const ShadowSettings& settings);

}  // namespace lampyris::deferred
