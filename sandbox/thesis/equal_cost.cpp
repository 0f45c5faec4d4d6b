#include "thesis/equal_cost.h"

#include "statistics.h"
#include "thesis/path_search.h"

namespace lampyris::sandbox::thesis {
namespace {

std::vector<double> costsOfFrames(const Contestant& contestant, Cost cost) {
    return cost == Cost::Indirect ? indirectMilliseconds(contestant)
                                  : contestant.series.frameMilliseconds();
}

/// What a frame of the candidate costs, as a share of the yardstick's. The median over the turns of
/// the ratio within each: a machine that others use slows both frames of a turn.
core::Result<double> shareOfYardstick(Pair& pair, const Study& study, Cost cost, uint32_t paths) {
    pair.candidate().options.photons = paths;
    TRY_VOID(race(pair.both, {study.size().warmup, study.size().frames, 0,
                              fmt::format("{}, {} paths, frame", study.progress, paths)}));
    std::vector<double> ratios = costsOfFrames(pair.candidate(), cost);
    const std::vector<double> budget = costsOfFrames(pair.yardstick(), cost);
    for (size_t i = 0; i < ratios.size(); ++i) ratios[i] /= budget[i];
    return summarise(ratios).median;
}

}  // namespace

core::Result<uint32_t> pathsOfEqualCost(Study& study, Pair& pair, Cost cost, uint32_t guess) {
    pair.candidate().options.photons.reset();
    const nlohmann::json what{{"search", settingsOf(pair.both)},
                              {"whole frame", cost == Cost::Frame},
                              {"guess", guess},
                              {"frames", study.size().frames},
                              {"warmup", study.size().warmup}};
    const std::string& name = pair.candidate().name;
    TRY(const Row found, study.row(what, [&]() -> core::Result<Row> {
        const auto share = [&](uint32_t paths) {
            return shareOfYardstick(pair, study, cost, paths);
        };
        TRY(const uint32_t paths, searchPaths(share, 1.0, guess));
        return Row{{name, {{kPaths, {static_cast<double>(paths), 0.0}}}}};
    }));
    return static_cast<uint32_t>(found.at(name).at(kPaths).mean);
}

}  // namespace lampyris::sandbox::thesis
