#include "deferred/shadow.h"

#include <algorithm>
#include <bit>

#include "core/check.h"
#include "deferred/shaders.h"
#include "shared/scene.h"

namespace lampyris::deferred {
namespace {

/// Bits that hold a number of rays, one at least.
uint32_t planesOf(uint32_t rays) {
    return static_cast<uint32_t>(std::bit_width(rays | 1u));
}

graph::Image addPenumbra(graph::Frame& frame, const Surface& surface, const LightLists& lights,
                         graph::Image counts, const Shadows& shadows, graph::Extent size) {
    auto node = frame.compute("shadow/penumbra", shaders::shadowPenumbra);
    node.uniformData(shared::SLOT_VIEW, surface.view)
        .read(shared::SLOT_LIGHT_MASKS, lights.masks)
        .sample(shared::SLOT_SHADOW_COUNTS, counts)
        .sample(shared::SLOT_SHADOW_GUIDE, shadows.guide)
        .push(shadows.params);
    const uint32_t layers = shadows.params.maskWords * shared::SHARE_PLANES;
    const graph::Image shares =
        node.write(shared::SLOT_SHADOW_SHARES,
                   frame.image("shadow shares", {graph::Format::R32Uint, size, layers, true}));
    node.dispatchOver(size);
    return shares;
}

}  // namespace

core::Result<void> checkShadowCounts(uint32_t lights, uint32_t maxImageArrayLayers) {
    constexpr uint32_t kPlanes = std::max(shared::SHARE_PLANES, shared::SHADOW_MOST_PLANES);
    const uint32_t most = 32 * (maxImageArrayLayers / kPlanes);
    if (lights <= most) return {};
    return core::error(
        "{} lights cast shadows: the device's limit maxImageArrayLayers, {}, has room for {} "
        "lights",
        lights, maxImageArrayLayers, most);
}

Shadows addShadow(graph::Frame& frame, const Surface& surface, const LightLists& lights,
                  const residency::SceneHandles& scene, const accel::AccelHandles& accel,
                  const ShadowSettings& settings) {
    const graph::Extent size =
        graph::Extent{surface.view.width, surface.view.height}.dividedBy(settings.divisor);
    Shadows shadows;
    shadows.params = lights.params;
    shadows.params.divisor = settings.divisor;
    shadows.params.coarseWidth = size.width;
    shadows.params.coarseHeight = size.height;
    shadows.params.rays = settings.rays;
    shadows.params.planes = planesOf(settings.rays);
    shadows.params.seed = settings.seed;
    CHECK(settings.rays > 0u);
    CHECK(shadows.params.planes <= shared::SHADOW_MOST_PLANES);

    auto node = frame.compute("shadow", shaders::shadow);
    bindSurface(node, surface);
    accel::bindTraversal(node, accel, scene);
    node.read(shared::SLOT_LIGHTS, scene.lights)
        .read(shared::SLOT_LIGHT_MASKS, lights.masks)
        .push(shadows.params);
    const uint32_t layers = shadows.params.maskWords * shadows.params.planes;
    const graph::Image counts =
        node.write(shared::SLOT_SHADOW_COUNTS,
                   frame.image("shadow counts", {graph::Format::R32Uint, size, layers, true}));
    shadows.guide = node.write(shared::SLOT_SHADOW_GUIDE,
                               frame.image("shadow guide", {graph::Format::RGBA32Uint, size}));
    node.dispatchOver(size);
    shadows.shares = addPenumbra(frame, surface, lights, counts, shadows, size);
    return shadows;
}

}  // namespace lampyris::deferred
