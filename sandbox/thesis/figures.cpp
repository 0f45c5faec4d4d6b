#include "thesis/figures.h"

#include <array>

#include "evaluation/comparison.h"
#include "statistics.h"

namespace lampyris::sandbox::thesis {
namespace {

/// Patterns of what is no indirect light; in tables all other nodes are, whatever their names.
const std::array<std::string, 11> kDirectNodes{"gbuffer*", "sphere_direct*", "composite*", "other*",
                                               "shadow*",  "refit*",         "tlas*",      "skin*",
                                               "morph*",   "upload*",        "overlay*"};
const std::array<std::string, 1> kTraceNodes{"photon_trace*"};
const std::array<std::string, 1> kAllNodes{"*"};

/// A frame each, in milliseconds.
struct Costs {
    std::vector<double> direct, trace, estimate, between;
};

Costs splitOf(const FrameSeries& series) {
    Costs costs{series.sumOf(kDirectNodes), series.sumOf(kTraceNodes), {}, {}};
    const std::vector<double> all = series.sumOf(kAllNodes);
    for (size_t i = 0; i < series.frames(); ++i) {
        costs.estimate.push_back(all[i] - costs.direct[i] - costs.trace[i]);
        costs.between.push_back(series.frameMilliseconds()[i] - all[i]);
    }
    return costs;
}

}  // namespace

Spread spreadOf(std::span<const double> values) {
    const Statistics s = summarise(values);
    return {s.mean, s.stddev};
}

Figures costsOf(const Contestant& contestant) {
    const Costs costs = splitOf(contestant.series);
    return {{kFrame, spreadOf(contestant.series.frameMilliseconds())},
            {kStored, spreadOf(contestant.photonsStored)},
            {kPaths, {static_cast<double>(contestant.report.paths), 0.0}},
            {kDirect, spreadOf(costs.direct)},
            {kTrace, spreadOf(costs.trace)},
            {kEstimate, spreadOf(costs.estimate)},
            {kBetween, spreadOf(costs.between)}};
}

std::vector<double> indirectMilliseconds(const Contestant& contestant) {
    Costs costs = splitOf(contestant.series);
    for (size_t i = 0; i < costs.trace.size(); ++i) costs.trace[i] += costs.estimate[i];
    return costs.trace;
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
