// `lampyris bench binning`: photons to tiles and on to the picture, `full` beside the yardstick
// `thesis`.
#include <fmt/format.h>

#include <array>

#include "bench.h"
#include "shared/view.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

using photon_gi::Pipeline;

constexpr const char* kBinning = "tile_bin*";
constexpr std::array<const char*, 3> kPhotonGi{kBinning, "gather*", "upsample*"};

struct Setting {
    uint32_t photons;
    float radiusMetres;
};

Contestant contestant(const BenchCall& call, const Setting& setting, const char* name,
                      Pipeline pipeline, uint32_t bounces) {
    Contestant c{name, call.options};
    const graph::Extent size = call.quick ? graph::Extent{960, 540} : graph::Extent{1920, 1080};
    c.options.scene = "cornell";
    c.options.pipeline = pipeline;
    c.options.size = call.options.size.value_or(size);
    c.options.photons = setting.photons;
    c.options.radius = setting.radiusMetres;
    c.options.maxBounces = bounces;
    c.options.gather = photon_gi::Gather::Tiles;
    c.options.gatherDivisor = 2;
    return c;
}

/// `full` as it is, `full` with the one bounce of `thesis`, and `thesis`.
core::Result<std::vector<Contestant>> measure(const BenchCall& call, const Setting& setting) {
    const uint32_t bounces = call.options.maxBounces.value_or(8);
    std::vector<Contestant> three{contestant(call, setting, "full", Pipeline::Full, bounces),
                                  contestant(call, setting, "full, one bounce", Pipeline::Full, 1),
                                  contestant(call, setting, "thesis", Pipeline::Thesis, 1)};
    const uint32_t frames = call.options.frames.value_or(call.quick ? 5 : 15);
    TRY_VOID(race(three, {call.options.warmup.value_or(2), frames}));
    return three;
}

double medianOf(const Contestant& c, std::span<const char* const> nodes) {
    const std::vector<std::string> names(nodes.begin(), nodes.end());
    return summarise(c.series.sumOf(names)).median;
}

std::string title(const char* what, const Contestant& c) {
    const photon_gi::Settings s = settingsOf(c.options);
    return fmt::format("{}: cornell, {}x{}, {} paths, radius {} m; medians of {} frames on {}",
                       what, c.size.width, c.size.height, s.photonPaths, s.radiusMetres,
                       c.series.frames(), c.device);
}

/// Tile–photon tests a second: every tile looks at every photon.
double testsPerSecond(const Contestant& thesis, double milliseconds) {
    const graph::Extent tiles = thesis.size.dividedBy(shared::TILE_PIXELS);
    const uint64_t tests =
        uint64_t{tiles.width} * tiles.height * thesis.report.counters.photonsStored;
    return static_cast<double>(tests) / milliseconds * 1000.0;
}

Table binningTable(const std::vector<Contestant>& three) {
    Table table{
        "binning",
        title("Binning", three.front()),
        {"pipeline", "photons", "pairs", "tile_bin ms", "thesis ÷ this", "million tests a second"},
        {}};
    const double thesis = medianOf(three.back(), std::array{kBinning});
    for (const Contestant& c : three) {
        const double own = medianOf(c, std::array{kBinning});
        const bool tests = c.options.pipeline == Pipeline::Thesis;
        table.rows.push_back({c.name, fmt::format("{}", c.report.counters.photonsStored),
                              fmt::format("{}", c.report.counters.pairs),
                              fmt::format("{:.2f}", own), fmt::format("{:.1f}", thesis / own),
                              tests ? fmt::format("{:.0f}", 1e-6 * testsPerSecond(c, own)) : "–"});
    }
    return table;
}

Table photonGiTable(const std::vector<Contestant>& three) {
    Table table{"photon_gi",
                title("Binning, gather and up-sampling", three.front()),
                {"pipeline", "photons", "tile_bin ms", "gather ms", "upsample ms", "sum ms",
                 "thesis ÷ this"},
                {}};
    const double thesis = medianOf(three.back(), kPhotonGi);
    for (const Contestant& c : three) {
        std::vector<std::string> row{c.name, fmt::format("{}", c.report.counters.photonsStored)};
        for (const char* node : kPhotonGi)
            row.push_back(fmt::format("{:.2f}", medianOf(c, std::array{node})));
        const double sum = medianOf(c, kPhotonGi);
        row.insert(row.end(), {fmt::format("{:.2f}", sum), fmt::format("{:.1f}", thesis / sum)});
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

core::Result<void> benchBinning(const BenchCall& call) {
    TRY(const auto binning, measure(call, {5000, 0.25f}));
    TRY_VOID(publish(binningTable(binning), call.out));
    TRY(const auto photonGi, measure(call, {1000, 1.0f}));
    return publish(photonGiTable(photonGi), call.out);
}

}  // namespace lampyris::sandbox
