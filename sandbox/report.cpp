#include "report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lampyris::sandbox {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Statistics& s) {
    return {{"mean", s.mean}, {"stddev", s.stddev}, {"median", s.median},
            {"p95", s.p95},   {"min", s.min},       {"max", s.max}};
}

Json toJson(const glm::dvec3& rgb) {
    return Json::array({rgb.r, rgb.g, rgb.b});
}

Json nodesJson(const FrameSeries& series) {
    Json nodes = Json::array();
    for (const NodeSummary& node : series.summariseNodes())
        nodes.push_back({{"name", node.name},
                         {"gpu_ms", toJson(node.gpuMilliseconds)},
                         {"cpu_record_ms", toJson(node.cpuRecordMilliseconds)}});
    return nodes;
}

Json photonsJson(const photon_gi::FrameReport& r) {
    return {{"paths", r.paths},
            {"stored", r.counters.photonsStored},
            {"dropped", r.counters.photonsDropped},
            {"retraced", r.retraced},
            {"emitted_watts", toJson(r.energy.emitted)},
            {"absorbed_watts", toJson(r.energy.absorbed)},
            {"escaped_watts", toJson(r.energy.escaped)},
            {"in_flight_watts", toJson(r.energy.inFlight)},
            {"roulette_watts", toJson(r.energy.roulette)}};
}

Json accelJson(const accel::AccelCounts& counts, const Measured& measured) {
    return {{"triangles", counts.triangles},
            {"blas", counts.blas},
            {"refits", measured.refits},
            {"rebuilds", measured.rebuilds},
            {"refit_ms", toJson(summarise(measured.refitMilliseconds))},
            {"rebuild_ms", toJson(summarise(measured.rebuildMilliseconds))},
            {"sah_ratio_max", measured.sahRatioMax}};
}

}  // namespace

Json settingsJson(const Options& o) {
    const photon_gi::Settings s = settingsOf(o);
    return {{"quality", name(o.quality)},
            {"photons", s.photonPaths},
            {"radius", s.radiusMetres},
            {"max_bounces", s.maxBounces},
            {"gather", name(s.gather)},
            {"gather_divisor", s.gatherDivisor},
            {"gather_rays", s.gatherRays},
            {"shadow_divisor", s.shadowDivisor},
            {"shadow_rays", s.shadowRays},
            {"filter_levels", s.filterLevels},
            {"history", s.history},
            {"reseed", s.reseed},
            {"guiding", guided(s)},
            {"retrace", name(s.retrace)},
            {"light_cutoff", s.lightCutoff},
            {"seed", s.seed},
            {"camera", o.camera},
            {"time", o.time},
            {"timestep", o.timestep.value_or(0.0)},
            {"warmup", o.warmup.value_or(0)},
            {"exposure", o.display.exposureEv},
            {"tonemap", core::name(o.display.tonemap)},
            {"output_node", o.outputNode}};
}

void Measured::add(LoopFrame frame) {
    series.add(frame.outcome.statistics);
    rebuilds += frame.rebuilds;
    refits += frame.refits;
    if (frame.refits > 0) refitMilliseconds.push_back(frame.refitMilliseconds);
    sahRatioMax = std::max(sahRatioMax, frame.sahRatioMax);
    if (frame.rebuilds > 0) rebuildMilliseconds.push_back(frame.rebuildMilliseconds);
    last = std::move(frame);
}

std::string makeReport(const Options& options, FrameLoop& loop, const Measured& measured) {
    const gpu::Device& device = loop.device();
    const photon_gi::FrameReport& r = measured.last.outcome.report;
    const execute::FrameStatistics& frame = measured.last.outcome.statistics;
    const graph::Extent size = loop.request.size;
    const Json report{{"device", device.info().name},
                      {"driver", device.info().driver},
                      {"scene", options.scene},
                      {"size", {size.width, size.height}},
                      {"pipeline", name(options.pipeline)},
                      {"settings", settingsJson(options)},
                      {"frames", measured.series.frames()},
                      {"frame_ms", toJson(summarise(measured.series.frameMilliseconds()))},
                      {"nodes", nodesJson(measured.series)},
                      {"photons", photonsJson(r)},
                      {"tiles",
                       {{"pairs", r.counters.pairs},
                        {"dropped", r.counters.pairsDropped},
                        {"max_in_tile", r.counters.mostInTile}}},
                      {"gather", {{"pixels_recomputed", r.counters.pixelsRecomputed}}},
                      {"grid", {{"cells", r.counters.cells}, {"dropped", r.counters.cellsDropped}}},
                      {"lights", {{"cut_off_watts", toJson(glm::dvec3(r.cutOffWatts))}}},
                      {"accel", accelJson(loop.renderer().accel().counts(), measured)},
                      {"memory",
                       {{"device_bytes", frame.deviceBytes},
                        {"transient_bytes", frame.transientBytes},
                        {"transient_bytes_without_aliasing", frame.transientBytesWithoutAliasing}}},
                      {"valid", r.valid},
                      {"validation", device.validated() ? "core+sync" : "off"},
                      {"validation_messages", device.validationMessages().size()}};
    return report.dump(2) + "\n";
}

}  // namespace lampyris::sandbox
