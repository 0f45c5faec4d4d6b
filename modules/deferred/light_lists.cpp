#include "deferred/light_lists.h"

#include <algorithm>

#include "deferred/shaders.h"
#include "deferred/view.h"
#include "shared/scene.h"

namespace lampyris::deferred {
namespace {

/// [chosen] 4096 samples give 1 % of the mean. Among many lights fewer do, and lavapipe ends a
/// shader's loops after 65535 turns in all [measured]: two for each sample of a thread and light.
uint32_t reachGrid(uint32_t lights) {
    if (lights <= 1024) return 64;
    return lights <= 4096 ? 32 : 16;
}

}  // namespace

LightLists addLightLists(graph::Frame& frame, const Surface& surface, const TileBounds& bounds,
                         const residency::SceneHandles& scene, float cutoff, uint32_t seed) {
    LightLists lists;
    const uint32_t words = std::max(1u, (scene.lightCount + 31) / 32);
    lists.params = {
        scene.lightCount, words, cutoff, seed, reachGrid(scene.lightCount), 1, 0, 0, 0, 0, 0, 0};

    auto reach = frame.compute("sphere_direct/reach", shaders::lightReach);
    bindSurface(reach, surface);
    reach.read(shared::SLOT_LIGHTS, scene.lights).push(lists.params);
    lists.reach = reach.write(
        shared::SLOT_LIGHT_REACH,
        frame.buffer("light reach", {(uint64_t{scene.lightCount} + 3) * sizeof(float)}));
    reach.dispatch(1);

    const uint32_t tiles = tileCount(surface.view);
    const uint64_t maskBytes = uint64_t{tiles} * 2 * lists.params.maskWords * sizeof(uint32_t);
    auto cull = frame.compute("sphere_direct/cull", shaders::lightCull);
    cull.read(shared::SLOT_TILE_BOUNDS, bounds.bounds)
        .read(shared::SLOT_LIGHTS, scene.lights)
        .read(shared::SLOT_LIGHT_REACH, lists.reach)
        .uniformData(shared::SLOT_VIEW, surface.view)
        .push(lists.params);
    lists.masks = cull.write(shared::SLOT_LIGHT_MASKS, frame.buffer("light masks", {maskBytes}));
    cull.dispatch((tiles + 63) / 64);
    return lists;
}

}  // namespace lampyris::deferred
