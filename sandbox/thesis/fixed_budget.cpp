// `lampyris bench fixed-budget`: the Thesis' table 6.2. For each radius the path count is searched
// for whose frame costs what one of 1000 paths and radius 1.0 m costs in the same pipeline on this
// machine; the Thesis' budget was its own frame of that setting.
#include <cmath>

#include "thesis/cost_plot.h"
#include "thesis/equal_cost.h"
#include "thesis/estimators.h"
#include "thesis/scaling_table.h"
#include "thesis/truth.h"

namespace lampyris::sandbox {
namespace {

using namespace thesis;
using photon_gi::Pipeline;

constexpr StudySize kQuick{{480, 270}, 5, 2, 256, 1};
constexpr uint32_t kMiddlePaths = 1000;
constexpr float kMiddleRadiusMetres = 1.0f;
constexpr const char* kMiddle = "middle row";

/// The middle row, and the setting that is to cost as much.
Pair pairOf(const Study& study, Pipeline pipeline) {
    Pair pair{
        {study.contestant(pipeline, study.scene()), study.contestant(pipeline, study.scene())}};
    Contestant& middle = pair.yardstick();
    middle.name = kMiddle;
    middle.options.photons = kMiddlePaths;
    middle.options.radius = kMiddleRadiusMetres;
    return pair;
}

/// A row a radius of table 6.2.
core::Result<std::vector<ScalingRow>> measure(Study& study, const Truth& truth, Pipeline pipeline) {
    Pair pair = pairOf(study, pipeline);
    std::vector<ScalingRow> rows;
    for (const PrintedRow& printed : table62()) {
        Options& options = pair.candidate().options;
        options.radius = static_cast<float>(printed.radiusMetres);
        study.progress = fmt::format("{}, radius {}", name(pipeline), printed.radiusMetres);
        // The rest of a frame costs the same in both, and would only add its noise. The Thesis' own
        // estimate to begin with: N = c/r.
        const auto guess =
            static_cast<uint32_t>(kMiddlePaths * kMiddleRadiusMetres / *options.radius);
        TRY(options.photons, pathsOfEqualCost(study, pair, Cost::Indirect, guess));
        study.progress += ", frame";
        TRY(const Row row, study.race(pair.both, &truth));
        ScalingRow& kept =
            rows.emplace_back(ScalingRow{printed, printed.radiusMetres, row.at(name(pipeline))});
        kept.here["budget"] = row.at(kMiddle).at(kFrame);
    }
    return rows;
}

Table budgetTable(const Study& study, const Truth& truth, Pipeline pipeline,
                  const std::vector<ScalingRow>& rows) {
    const auto title = fmt::format(
        "Fixed budget (table 6.2): {}; {}; each frame is to cost what one of {} paths and "
        "radius {} m costs, drawn in turn with it; errors of the last {} against {}",
        describe(sandbox::settingsOf(study.contestant(pipeline, study.scene()).options)),
        study.about(study.scene()), kMiddlePaths, kMiddleRadiusMetres, study.size().judged,
        truth.about);
    Table table = scalingTable(name(pipeline), title, rows);
    constexpr std::ptrdiff_t kAfterFrame = 5;
    table.header.insert(table.header.begin() + kAfterFrame, "budget ms");
    for (size_t i = 0; i < rows.size(); ++i)
        table.rows[i].insert(table.rows[i].begin() + kAfterFrame,
                             fmt::format("{:.1f}", rows[i].here.at("budget").mean));
    return table;
}

std::vector<Affordable> storedOf(const std::vector<ScalingRow>& rows) {
    std::vector<Affordable> stored;
    stored.reserve(rows.size());
    for (const ScalingRow& row : rows)
        stored.push_back({row.radiusMetres, row.here.at(kStored).mean});
    return stored;
}

std::vector<Affordable> storedInPrint() {
    std::vector<Affordable> stored;
    stored.reserve(table62().size());
    for (const PrintedRow& row : table62())
        stored.push_back({row.radiusMetres, static_cast<double>(row.stored)});
    return stored;
}

/// "596/r + 165/r²"
std::string formulaOf(const Estimator& e) {
    if (e.c2 == 0.0) return fmt::format("{:.0f}/r", e.c1);
    if (e.c1 == 0.0) return fmt::format("{:.0f}/r²", e.c2);
    return fmt::format("{:.0f}/r {} {:.0f}/r²", e.c1, e.c2 < 0.0 ? "−" : "+", std::abs(e.c2));
}

/// Adds the estimators of one series to the table, and gives their plot.
plot::Chart fitAndPlot(const std::string& name, const std::vector<Affordable>& stored,
                       Table& table) {
    plot::Chart chart{name, "radius (m)", "photons stored", plot::Scale::Logarithmic, {}};
    plot::Series measured{"measured", {}, false};
    measured.points.reserve(stored.size());
    for (const Affordable& a : stored) measured.points.push_back({a.radiusMetres, a.photons});
    chart.series.push_back(measured);
    for (const Estimator& e : fitEstimators(stored)) {
        table.rows.push_back({name, e.name, fmt::format("{:.1f}", e.c1),
                              fmt::format("{:.1f}", e.c2), fmt::format("{:.1f}", e.rmsPhotons)});
        plot::Series line{formulaOf(e), {}, true, false};
        constexpr int kSteps = 60;
        for (int i = 0; i <= kSteps; ++i) {
            const double radius = std::lerp(stored.front().radiusMetres, stored.back().radiusMetres,
                                            double{1} * i / kSteps);
            line.points.push_back({radius, e.at(radius)});
        }
        chart.series.push_back(line);
    }
    return chart;
}

plot::StackedBars splitOf(const std::string& name, const std::vector<ScalingRow>& rows) {
    plot::StackedBars bars = costBars(name + ": paths (radius, m)");
    for (const ScalingRow& row : rows)
        bars.bars.push_back(costBar(fmt::format("{:.0f}", row.here.at(kPaths).mean),
                                    fmt::format("({:.2f})", row.radiusMetres), row.here));
    return bars;
}

}  // namespace

core::Result<void> benchFixedBudget(const BenchCall& call) {
    TRY(Study study, Study::open(call, "fixed-budget", kQuick));
    TRY(const Truth truth, findTruth(study, study.scene()));
    Table fits{"estimators",
               "Photons stored N that a budget affords at radius r: least squares of table 6.2",
               {"measured", "estimator", "c₁", "c₂", "RMS photons"},
               {}};
    std::vector<plot::Chart> curves{fitAndPlot("the Thesis", storedInPrint(), fits)};
    std::vector<plot::StackedBars> splits;
    for (const Pipeline pipeline : {Pipeline::Thesis, Pipeline::Full}) {
        TRY(const auto rows, measure(study, truth, pipeline));
        TRY_VOID(study.publish(budgetTable(study, truth, pipeline, rows)));
        curves.push_back(fitAndPlot(name(pipeline), storedOf(rows), fits));
        splits.push_back(splitOf(name(pipeline), rows));
    }
    TRY_VOID(study.publish(fits));
    TRY_VOID(study.publishPlot("estimators", plot::sideBySide(curves)));
    return study.publishPlot("costs", plot::sideBySide(splits));
}

}  // namespace lampyris::sandbox
