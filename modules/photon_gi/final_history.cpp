#include "photon_gi/final_history.h"

#include "photon_gi/shaders.h"

namespace lampyris::photon_gi {

graph::ImageDesc historyMean(const shared::View& view, uint32_t divisor) {
    return {graph::Format::RGBA32Float, coarseSize(view, divisor)};
}

CoarseIrradiance addFinalHistory(graph::Frame& frame, const deferred::Surface& surface,
                                 const CoarseIrradiance& newest, const Past& past, uint32_t frames,
                                 const FinalGatherSettings& settings) {
    if (frames == 0) return newest;
    const graph::ImageDesc desc = historyMean(surface.view, settings.divisor);
    const auto means = frame.history(kHistoryMean, desc, past.known);
    const auto slopes = frame.history("gather slope history", desc, past.known);
    const auto guides =
        frame.history("gather guide history", {graph::Format::RGBA32Uint, desc.extent}, past.known);
    const uint32_t before = past.known && past.same ? frames - 1 : 0;
    auto node = frame.compute("gather/history", shaders::finalHistory);
    bindCoarse(node, newest);
    node.uniformData(shared::SLOT_VIEW, surface.view)
        .uniformData(shared::SLOT_HISTORY_PARAMS,
                     shared::HistoryParams{past.worldToClip, before, 0, 0, 0})
        .sample(shared::SLOT_HISTORY_BEFORE, means.previous)
        .sample(shared::SLOT_HISTORY_SLOPE_BEFORE, slopes.previous)
        .sample(shared::SLOT_HISTORY_GUIDE_BEFORE, guides.previous)
        .push(finalParams(surface.view, settings));
    CoarseIrradiance mean;
    mean.irradiance =
        node.write(shared::SLOT_FINAL_COARSE,
                   frame.image("mean irradiance", {graph::Format::RGBA32Uint, desc.extent}));
    (void)node.write(shared::SLOT_HISTORY_MEAN, means.current);
    (void)node.write(shared::SLOT_HISTORY_SLOPE, slopes.current);
    mean.guide = node.write(shared::SLOT_FINAL_GUIDE, guides.current);
    node.dispatchOver(desc.extent);
    return mean;
}

}  // namespace lampyris::photon_gi
