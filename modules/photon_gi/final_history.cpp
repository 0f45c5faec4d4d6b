#include "photon_gi/final_history.h"

#include <algorithm>

#include "photon_gi/shaders.h"
#include "shared/history.h"

namespace lampyris::photon_gi {

namespace {

// [chosen] Boxes that a texel looks at; what is more counts as one box around them.
constexpr size_t kMostRegions = 48;
// [chosen] Lights that a texel weighs; with more the brightest stand for all.
constexpr size_t kMostLights = 64;

void addRegions(const std::vector<scene::ChangedRegion>& regions,
                std::vector<shared::ChangedPlace>& places) {
    scene::ChangedRegion rest;
    for (const scene::ChangedRegion& region : regions) {
        if (places.size() + 1 < kMostRegions) {
            places.push_back({glm::vec4(region.boundsWorld.lower, region.movedMetres),
                              glm::vec4(region.boundsWorld.upper, 0.0f), glm::vec4(0.0f)});
            continue;
        }
        rest.boundsWorld.grow(region.boundsWorld);
        rest.movedMetres = std::max(rest.movedMetres, region.movedMetres);
    }
    if (!rest.boundsWorld.empty())
        places.push_back({glm::vec4(rest.boundsWorld.lower, rest.movedMetres),
                          glm::vec4(rest.boundsWorld.upper, 0.0f), glm::vec4(0.0f)});
}

/// Those that changed, and those that did not: a change counts as a share of all.
void addLights(const Past& past, std::vector<shared::ChangedPlace>& places) {
    if (past.changes.lights.empty()) return;
    std::vector<scene::ChangedLight> lights = past.changes.lights;
    for (const scene::SnapshotLight& light : past.lights) {
        const bool changed =
            std::any_of(past.changes.lights.begin(), past.changes.lights.end(),
                        [&](const auto& c) { return c.positionWorld == light.positionWorld; });
        const glm::vec3& power = light.powerWatts;
        if (!changed)
            lights.push_back(
                {light.positionWorld, (power.x + power.y + power.z) / 3.0f, 0.0f, 0.0f});
    }
    std::stable_sort(lights.begin(), lights.end(),
                     [](const auto& a, const auto& b) { return a.watts > b.watts; });
    lights.resize(std::min(lights.size(), kMostLights));
    for (const scene::ChangedLight& light : lights)
        places.push_back({glm::vec4(light.positionWorld, light.movedMetres),
                          glm::vec4(0.0f, 0.0f, 0.0f, light.watts),
                          glm::vec4(light.changedWatts, 0.0f, 0.0f, 0.0f)});
}

}  // namespace

graph::ImageDesc historyMean(const shared::View& view, uint32_t divisor) {
    return {graph::Format::RGBA32Float, coarseSize(view, divisor)};
}

CoarseIrradiance addFinalHistory(graph::Frame& frame, const deferred::Surface& surface,
                                 const CoarseIrradiance& newest, graph::Image motion,
                                 const Past& past, uint32_t frames,
                                 const FinalGatherSettings& settings) {
    if (frames == 0) return newest;
    const graph::ImageDesc desc = historyMean(surface.view, settings.divisor);
    const auto means = frame.history(kHistoryMean, desc, past.known);
    const auto slopes = frame.history("gather slope history", desc, past.known);
    const auto guides =
        frame.history("gather guide history", {graph::Format::RGBA32Uint, desc.extent}, past.known);
    const auto moments = frame.history("gather moments history", desc, past.known);
    const bool goesOn = past.known && past.same && !past.changes.everything;
    std::vector<shared::ChangedPlace> places;
    addRegions(past.changes.regions, places);
    const auto regions = static_cast<uint32_t>(places.size());
    addLights(past, places);
    const shared::HistoryParams params{past.worldToClip, goesOn ? frames - 1 : 0, regions,
                                       static_cast<uint32_t>(places.size()) - regions,
                                       past.doubted ? 1u : 0u};
    if (places.empty()) places.emplace_back();
    auto node = frame.compute("gather/history",
                              motion.valid() ? shaders::finalHistoryMoving : shaders::finalHistory);
    if (motion.valid()) node.sample(shared::SLOT_HISTORY_MOTION, motion);
    bindCoarse(node, newest);
    node.uniformData(shared::SLOT_VIEW, surface.view)
        .storageData(shared::SLOT_HISTORY_PARAMS, &params, sizeof(params))
        .storageData(shared::SLOT_HISTORY_CHANGES, places.data(),
                     places.size() * sizeof(shared::ChangedPlace))
        .sample(shared::SLOT_HISTORY_MOMENTS_BEFORE, moments.previous)
        .sample(shared::SLOT_HISTORY_BEFORE, means.previous)
        .sample(shared::SLOT_HISTORY_SLOPE_BEFORE, slopes.previous)
        .sample(shared::SLOT_HISTORY_GUIDE_BEFORE, guides.previous)
        .push(finalParams(surface.view, settings));
    CoarseIrradiance mean;
    mean.irradiance =
        node.write(shared::SLOT_FINAL_COARSE,
                   frame.image("mean irradiance", {graph::Format::RGBA32Uint, desc.extent}));
    mean.mean = node.write(shared::SLOT_HISTORY_MEAN, means.current);
    (void)node.write(shared::SLOT_HISTORY_SLOPE, slopes.current);
    (void)node.write(shared::SLOT_HISTORY_MOMENTS, moments.current);
    mean.guide = node.write(shared::SLOT_FINAL_GUIDE, guides.current);
    node.dispatchOver(desc.extent);
    return mean;
}

}  // namespace lampyris::photon_gi
