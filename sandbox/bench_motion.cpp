// `lampyris bench motion`: what motion adds to a frame, and what a frame saves where nothing moves.
// All ways of drawing take turns, frame by frame.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "bench.h"
#include "courtyard/courtyard.h"
#include "progress.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

using photon_gi::Retrace;

constexpr double kTimestep = 1.0 / 60.0;  // [chosen] seconds a frame of the moving ones

/// One way of drawing the scene, and what its frames cost.
struct Way {
    std::string name;
    double timestep;  ///< seconds a frame
    Retrace retrace;
    uint32_t first;                ///< frames before this one are not measured
    uint32_t end;                  ///< nor are this one and those after it
    std::optional<double> most{};  ///< what is aimed at, in frames of the frozen scene
    std::unique_ptr<FrameLoop> loop{};
    std::vector<double> gpu{}, update{}, whole{};  ///< milliseconds, a frame each
    uint64_t paths = 0, retraced = 0;
    uint32_t refits = 0, rebuilds = 0, repeats = 0;

    [[nodiscard]] double milliseconds() const { return summarise(whole).median; }
};

constexpr size_t kFrozen = 1;  ///< the way that others are measured against

std::vector<Way> waysOf(uint32_t warmup, uint32_t frames, uint32_t history) {
    const uint32_t end = warmup + frames;
    // From here on each frame repeats the last: the mean is full, and one more is drawn to stay.
    const uint32_t settled = history + 4;
    const uint32_t firstStill = std::min(warmup, history);
    std::vector<Way> ways;
    ways.push_back({"moving, all retraced", kTimestep, Retrace::All, warmup, end, 1.15});
    ways.push_back({"frozen, all retraced", 0.0, Retrace::All, warmup, end});
    ways.push_back({"moving, auto", kTimestep, Retrace::Auto, warmup, end});
    ways.push_back({"still, auto, history filling", 0.0, Retrace::Auto, firstStill,
                    std::min(firstStill + frames, history + 1), 0.5});
    ways.push_back(
        {"still, auto, history full", 0.0, Retrace::Auto, settled, settled + frames, 0.5});
    return ways;
}

core::Result<void> draw(Way& way, uint32_t frameNumber) {
    TRY(const LoopFrame frame, way.loop->draw(frameNumber));
    if (frameNumber < way.first || frameNumber >= way.end) return {};
    way.gpu.push_back(frame.outcome.statistics.gpuMilliseconds);
    way.update.push_back(frame.updateMilliseconds);
    way.whole.push_back(way.gpu.back() + way.update.back());
    way.paths += frame.outcome.report.paths;
    way.retraced += frame.outcome.report.retraced;
    way.refits += frame.refits;
    way.rebuilds += frame.rebuilds;
    way.repeats += frame.repeats;
    return {};
}

/// What needs more frames before it is measured draws those first, alone; then all take turns.
core::Result<void> drawAll(std::vector<Way>& ways, uint32_t measured) {
    std::vector<uint32_t> next;
    for (Way& way : ways) {
        Progress progress{"frame to warm up", way.first};
        for (uint32_t i = 0; i < way.first; ++i) {
            progress.show(i);
            TRY_VOID(draw(way, i));
        }
        next.push_back(way.first);
    }
    Progress progress{"frame", measured};
    for (uint32_t i = 0; i < measured; ++i) {
        progress.show(i);
        for (size_t w = 0; w < ways.size(); ++w) {
            if (next[w] >= ways[w].end) continue;
            TRY_VOID(draw(ways[w], next[w]++));
        }
    }
    return {};
}

std::vector<std::string> rowOf(const Way& way, double frozen) {
    const auto aFrame = [&](double sum) {
        return fmt::format("{:.2f}", sum / static_cast<double>(way.whole.size()));
    };
    if (way.whole.empty()) return {way.name, "0", "–", "–", "–", "–", "–", "–", "–", "–", "–", "–"};
    const double ratio = way.milliseconds() / frozen;
    return {way.name,
            fmt::format("{}", way.whole.size()),
            fmt::format("{:.2f}", summarise(way.gpu).median),
            fmt::format("{:.2f}", summarise(way.update).median),
            fmt::format("{:.2f}", way.milliseconds()),
            fmt::format("{:.3f}", ratio),
            way.most ? fmt::format("≤ {:.2f}", *way.most) : "",
            way.most ? (ratio <= *way.most ? "yes" : "no") : "",
            way.paths == 0 ? "–"
                           : fmt::format("{:.3f}", static_cast<double>(way.retraced) /
                                                       static_cast<double>(way.paths)),
            aFrame(way.refits),
            aFrame(way.rebuilds),
            aFrame(way.repeats)};
}

Table tableOf(const std::vector<Way>& ways, const std::string& scene, uint32_t history) {
    Table table{"motion",
                {},
                {"way", "frames", "GPU ms", "update ms", "both", "÷ frozen", "wanted", "met",
                 "retraced ÷ paths", "refits", "rebuilds", "repeats"},
                {}};
    FrameLoop& loop = *ways.front().loop;
    table.title = fmt::format(
        "{}, {}x{}, {} paths, history {}, moving by 1/60 s a frame: medians; refits, rebuilds and "
        "repeats a frame; on {}",
        scene, loop.request.size.width, loop.request.size.height, loop.request.settings.photonPaths,
        history, loop.device().info().name);
    for (const Way& way : ways) table.rows.push_back(rowOf(way, ways[kFrozen].milliseconds()));
    return table;
}

}  // namespace

core::Result<void> benchMotion(const BenchCall& call) {
    Options options = call.options;
    options.scene = call.scene.empty() ? std::string{courtyard::kSceneName} : call.scene;
    options.size =
        options.size.value_or(call.quick ? graph::Extent{160, 90} : graph::Extent{640, 360});
    const uint32_t frames = options.frames.value_or(call.quick ? 6 : 20);
    const uint32_t history = settingsOf(options).history;
    std::vector<Way> ways = waysOf(options.warmup.value_or(3), frames, history);
    for (Way& way : ways) {
        options.timestep = way.timestep;
        options.retrace = way.retrace;
        TRY(way.loop, FrameLoop::open(options));
    }
    TRY_VOID(drawAll(ways, frames));
    return publish(tableOf(ways, options.scene, history), call.out);
}

}  // namespace lampyris::sandbox
