#include "deferred/shadow.h"

#include "deferred/shaders.h"
#include "shared/scene.h"

namespace lampyris::deferred {

graph::Image addShadow(graph::Frame& frame, const Surface& surface, const LightLists& lights,
                       const residency::SceneHandles& scene, const accel::AccelHandles& accel) {
    const graph::Extent size{surface.view.width, surface.view.height};
    auto node = frame.compute("shadow", shaders::shadow);
    bindSurface(node, surface);
    accel::bindTraversal(node, accel, scene);
    node.read(shared::SLOT_LIGHTS, scene.lights)
        .read(shared::SLOT_LIGHT_MASKS, lights.masks)
        .push(lights.params);
    const graph::Image bits = node.write(
        shared::SLOT_SHADOW_MASKS,
        frame.image("shadow masks", {graph::Format::R32Uint, size, lights.params.maskWords, true}));
    node.dispatchOver(size);
    return bits;
}

}  // namespace lampyris::deferred
