#include "deferred/sphere_direct.h"

#include "deferred/shaders.h"
#include "shared/scene.h"

namespace lampyris::deferred {

DirectLight addSphereDirect(graph::Frame& frame, const Surface& surface, const LightLists& lights,
                            graph::Image shadowMasks, const residency::SceneHandles& scene) {
    const graph::Extent size{surface.view.width, surface.view.height};
    auto node =
        frame.compute("sphere_direct", shadowMasks.valid() ? shaders::sphereDirect
                                                           : shaders::sphereDirectUnshadowed);
    bindSurfaceMaterial(node, surface);
    node.read(shared::SLOT_LIGHTS, scene.lights)
        .read(shared::SLOT_LIGHT_REACH, lights.reach)
        .read(shared::SLOT_LIGHT_MASKS, lights.masks)
        .push(lights.params);
    if (shadowMasks.valid()) node.read(shared::SLOT_SHADOW_MASKS, shadowMasks);
    DirectLight direct;
    direct.irradiance =
        node.write(shared::SLOT_IRRADIANCE_DIRECT,
                   frame.image("direct irradiance", {graph::Format::RGBA16Float, size}));
    direct.specular =
        node.write(shared::SLOT_SPECULAR_DIRECT,
                   frame.image("direct specular", {graph::Format::RGBA16Float, size}));
    node.dispatchOver(size);
    return direct;
}

}  // namespace lampyris::deferred
