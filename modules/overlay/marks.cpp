#include "overlay/marks.h"

#include <algorithm>
#include <cmath>

#include "overlay/shaders.h"
#include "shared/overlay.h"

namespace lampyris::overlay {
namespace {

constexpr uint32_t kVerticesPerPhoton = 6;
constexpr uint32_t kVerticesPerBox = 24;

/// Each with and without hiding behind surfaces.
struct MarkPipelines {
    explicit MarkPipelines(const graph::Shader& vertex, bool lines)
        : tested(make(vertex, lines, true)), open(make(vertex, lines, false)) {}
    [[nodiscard]] const graph::RasterPipeline& of(bool throughWalls) const {
        return throughWalls ? open : tested;
    }
    graph::RasterPipeline tested, open;

 private:
    static graph::RasterPipeline make(const graph::Shader& vertex, bool lines, bool depthTest) {
        return {.vertex = &vertex,
                .fragment = &shaders::markFrag,
                .attributes = {},
                .depthTest = depthTest,
                .depthWrite = false,
                .lines = lines,
                .blend = true};
    }
};

void record(graph::RasterNode& node, const graph::Shader& vertex,
            const graph::RasterPipeline& pipeline, graph::Draw draw) {
    draw.pipeline = &pipeline;
    node.record({&vertex, &shaders::markFrag},
                [draw](graph::RasterCommands& commands) { commands.draw(draw); });
}

graph::Image addPhotonMarks(graph::Frame& frame, const photon_gi::Insides& insides,
                            const MarkChoice& choice, bool asPaths, graph::Image shown) {
    static const MarkPipelines points{shaders::photonsVert, false};
    static const MarkPipelines lines{shaders::pathsVert, true};
    const graph::Extent extent = frame.desc(shown).extent;
    const photons::PhotonList& photons = insides.photons;
    shared::MarkParams params{};
    params.pathCount = photons.pathCount;
    params.capacity = photons.capacity;
    params.most = std::max(choice.most, 1u);
    params.colouring =
        choice.colouring == Colouring::Bounce ? shared::MARK_BY_BOUNCE : shared::MARK_BY_POWER;
    params.brightness = photons.powerScale * std::exp2(choice.brightnessEv);
    params.radiusPixels = choice.radiusPixels;
    params.width = static_cast<float>(extent.width);
    params.height = static_cast<float>(extent.height);
    auto node = frame.raster(asPaths ? "overlay/paths" : "overlay/photons", extent);
    const graph::Image drawn = node.colour(0, shown);
    node.testDepth(insides.depth)
        .uniformData(shared::SLOT_VIEW, insides.view)
        .read(shared::SLOT_MARK_PHOTONS, photons.photons)
        .read(shared::SLOT_MARK_OFFSETS, photons.pathOffsets);
    graph::Draw draw;
    draw.count = asPaths ? 2 * (photons.perPath - 1) : kVerticesPerPhoton;
    draw.instances = std::min(asPaths ? photons.pathCount : photons.capacity, params.most);
    draw.pushConstants(params);
    record(node, asPaths ? shaders::pathsVert : shaders::photonsVert,
           (asPaths ? lines : points).of(choice.throughWalls), draw);
    return drawn;
}

graph::Image addBoxes(graph::Frame& frame, const photon_gi::Insides& insides,
                      const MarkChoice& choice, graph::Image shown) {
    static const MarkPipelines pipelines{shaders::boxesVert, true};
    auto node = frame.raster("overlay/boxes", frame.desc(shown).extent);
    const graph::Image drawn = node.colour(0, shown);
    node.testDepth(insides.depth)
        .uniformData(shared::SLOT_VIEW, insides.view)
        .uniformData(shared::SLOT_BOX_ROOT, insides.accel.root)
        .texels(shared::SLOT_BOX_NODES, insides.accel.nodes, graph::Format::RGBA32Uint);
    const shared::BoxParams params{std::clamp(choice.boxLevel, kLeastBoxLevel, kMostBoxLevel)};
    graph::Draw draw;
    draw.count = kVerticesPerBox;
    draw.instances = 1u << params.level;
    draw.pushConstants(params);
    record(node, shaders::boxesVert, pipelines.of(choice.throughWalls), draw);
    return drawn;
}

graph::Image addHeat(graph::Frame& frame, const photon_gi::Insides& insides,
                     const MarkChoice& choice, graph::Image shown) {
    const bool tiles = choice.heat == Heat::Tiles;
    if (!(tiles ? insides.tileRanges.valid() : insides.mean.valid())) return shown;
    const graph::Extent extent = frame.desc(shown).extent;
    shared::HeatParams params{std::max(choice.heatMost, 1e-6f), choice.heatOpacity,
                              insides.view.tilesX, 1};
    auto node = frame.compute("overlay/heat", tiles ? shaders::heatTiles : shaders::heat);
    if (tiles) {
        node.read(shared::SLOT_HEAT_RANGES, insides.tileRanges);
    } else {
        params.divisor = insides.meanDivisor;
        node.sample(shared::SLOT_HEAT_MEAN, insides.mean);
    }
    node.push(params);
    const graph::Image drawn = node.update(shared::SLOT_HEAT_SHOWN, shown);
    node.dispatchOver(extent);
    return drawn;
}

}  // namespace

bool hasHeat(Heat heat, const photon_gi::Settings& settings) {
    const bool indirect =
        settings.pipeline != photon_gi::Pipeline::Direct && settings.maxBounces > 0;
    switch (heat) {
        case Heat::None:
            return true;
        case Heat::Tiles:
            return indirect && !photon_gi::finalGathers(settings);
        case Heat::History:
            return indirect && photon_gi::finalGathers(settings);
    }
    return false;
}

graph::Image addMarks(graph::Frame& frame, const photon_gi::Insides& insides,
                      const MarkChoice& choice, graph::Image shown) {
    if (!insides.depth.valid()) return shown;  // the last picture is shown again
    if (choice.heat != Heat::None) shown = addHeat(frame, insides, choice, shown);
    const bool hasPhotons = insides.photons.photons.valid() && insides.photons.capacity > 0;
    if (choice.photons && hasPhotons) shown = addPhotonMarks(frame, insides, choice, false, shown);
    if (choice.paths && hasPhotons && insides.photons.perPath > 1)
        shown = addPhotonMarks(frame, insides, choice, true, shown);
    if (choice.boxes) shown = addBoxes(frame, insides, choice, shown);
    return shown;
}

}  // namespace lampyris::overlay
