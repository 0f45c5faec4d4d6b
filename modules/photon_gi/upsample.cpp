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
    node.sample(shared::SLOT_GATHER_COARSE, gathered.coarse)
        .uniformData(shared::SLOT_VIEW, surface.view)
        .push(shared::GatherParams{settings.radiusMetres, 1.0f, settings.divisor, coarse.width,
                                   coarse.height, 0, 0, 0.0f, 0, 0, 0, 0, 0, 0, 0, 0});
    graph::Image irradiance =
        node.write(shared::SLOT_GATHER_IRRADIANCE,
                   frame.image("indirect irradiance", {graph::Format::RGBA16Float, size}));
    node.dispatchOver(coarseBlocks(surface.view, settings.divisor));
    return addPlaceEstimates(frame, edges, gathered.estimates, EstimateFormat::Vec4, irradiance);
}

graph::Image addPlaceEstimates(graph::Frame& frame, const EdgeList& edges, graph::Buffer estimates,
                               EstimateFormat format, graph::Image irradiance) {
    auto place = frame.compute("upsample/place", format == EstimateFormat::Vec4
                                                     ? shaders::upsamplePlace
                                                     : shaders::upsamplePlaceHalf);
    place.read(shared::SLOT_GATHER_COUNTERS, edges.counters)
        .read(shared::SLOT_GATHER_LIST, edges.list)
        .read(shared::SLOT_GATHER_ESTIMATES, estimates);
    irradiance = place.update(shared::SLOT_GATHER_IRRADIANCE, irradiance);
    place.dispatchIndirect(edges.groups);
    return irradiance;
}

}  // namespace lampyris::photon_gi
