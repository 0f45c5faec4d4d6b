#include "photon_gi/composite.h"

#include "photon_gi/shaders.h"
#include "shared/scene.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {

graph::Image addComposite(graph::Frame& frame, const deferred::Surface& surface,
                          const deferred::DirectLight& direct, graph::Image indirect,
                          const deferred::LightLists& lights, const residency::SceneHandles& scene,
                          deferred::Keep keep) {
    const graph::Extent size{surface.view.width, surface.view.height};
    shared::GatherParams params{};
    params.lightCount = lights.params.lightCount;
    params.maskWords = lights.params.maskWords;
    auto node = frame.compute("composite",
                              indirect.valid() ? shaders::composite : shaders::compositeDirect);
    deferred::bindSurfaceMaterial(node, surface);
    node.sample(shared::SLOT_COMPOSITE_DIRECT, direct.irradiance)
        .sample(shared::SLOT_COMPOSITE_SPECULAR, direct.specular)
        .read(shared::SLOT_LIGHTS, scene.lights)
        .read(shared::SLOT_COMPOSITE_MASKS, lights.masks)
        .push(params);
    if (indirect.valid()) node.sample(shared::SLOT_COMPOSITE_INDIRECT, indirect);
    const graph::Image radiance =
        node.write(shared::SLOT_COMPOSITE_OUT,
                   deferred::keepable(frame, keep, kFinal, {graph::Format::RGBA16Float, size}));
    node.dispatchOver(size);
    return radiance;
}

graph::Image recallFinal(graph::Frame& frame, graph::Extent size) {
    return deferred::kept(frame, kFinal, {graph::Format::RGBA16Float, size});
}

}  // namespace lampyris::photon_gi
