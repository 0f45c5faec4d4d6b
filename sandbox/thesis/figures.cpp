#include "thesis/figures.h"

#include <array>

#include "evaluation/comparison.h"
#include "statistics.h"

namespace lampyris::sandbox::thesis {
namespace {

// DESIGN.md's list of what is no indirect light.
const std::array<std::string, 10> kDirectNodes{
    "gbuffer*", "sphere_direct*", "composite*", "shadow*", "refit*",
    "tlas*",    "skin*",          "morph*",     "upload*", "overlay*"};
const std::array<std::string, 1> kTraceNodes{"photon_trace*"};
const std::array<std::string, 1> kAllNodes{"*"};

}  // namespace

Spread spreadOf(std::span<const double> values) {
    const Statistics s = summarise(values);
    return {s.mean, s.stddev};
}

Figures costsOf(const Contestant& contestant) {
    const FrameSeries& series = contestant.series;
    const std::vector<double>& frame = series.frameMilliseconds();
    const std::vector<double> direct = series.sumOf(kDirectNodes);
    const std::vector<double> trace = series.sumOf(kTraceNodes);
    const std::vector<double> all = series.sumOf(kAllNodes);
    std::vector<double> estimate, between;
    for (size_t i = 0; i < frame.size(); ++i) {
        estimate.push_back(all[i] - direct[i] - trace[i]);
        between.push_back(frame[i] - all[i]);
    }
    return {{kFrame, spreadOf(frame)},
            {kStored, spreadOf(contestant.photonsStored)},
            {kPaths, {static_cast<double>(contestant.report.paths), 0.0}},
            {kDirect, spreadOf(direct)},
            {kTrace, spreadOf(trace)},
            {kEstimate, spreadOf(estimate)},
            {kBetween, spreadOf(between)}};
}

core::Result<Figures> errorsOf(std::span<const core::Image> pictures,
                               const evaluation::Picture& reference,
                               const core::DisplayTransform& display) {
    std::map<std::string, std::vector<double>> values;
    for (const core::Image& picture : pictures) {
        TRY(const auto shown, evaluation::fromLinear("frame", picture, display));
        TRY(const auto compared, evaluation::compare(shown, reference));
        for (const evaluation::Figure& figure : evaluation::figuresOf(compared))
            values[figure.name].push_back(figure.value);
    }
    Figures figures;
    for (const auto& [name, series] : values) figures[name] = spreadOf(series);
    return figures;
}

}  // namespace lampyris::sandbox::thesis
