#include "photon_gi/upsample.h"

#include "photon_gi/shaders.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {

graph::Image addUpsample(graph::Frame& frame, const deferred::Surface& surface,
                         const Gathered& gathered, const EdgeList& edges,
                         const GatherSettings& settings) {
    const graph::Extent size{surface.view.width, surface.view.height};
    const graph::Extent coarse = coarseSize(surface.view, settings.divisor);
    auto node = frame.compute("upsample", shaders::upsample);
    deferred::bindSurface(node, surface);
    node.sample(shared::SLOT_GATHER_COARSE, gathered.coarse)
        .sample(shared::SLOT_GATHER_EDGES, edges.edges)
        .read(shared::SLOT_GATHER_ESTIMATES, gathered.estimates)
        .push(shared::GatherParams{settings.radiusMetres, 1.0f, settings.divisor, coarse.width,
                                   coarse.height, 0, 0, 0.0f});
    const graph::Image irradiance =
        node.write(shared::SLOT_GATHER_IRRADIANCE,
                   frame.image("indirect irradiance", {graph::Format::RGBA16Float, size}));
    node.dispatchOver(size);
    return irradiance;
}

}  // namespace lampyris::photon_gi
