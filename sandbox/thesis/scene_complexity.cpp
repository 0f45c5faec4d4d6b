// `lampyris bench scene-complexity`: the Thesis' tables B.1 to B.4, cost over paths and radius in
// scenes of more and more triangles.
#include <algorithm>

#include "thesis/cost_plot.h"
#include "thesis/printed.h"
#include "thesis/study.h"

namespace lampyris::sandbox {
namespace {

using namespace thesis;
using photon_gi::Pipeline;

constexpr StudySize kQuick{{320, 180}, 2, 0, 0, 1};
constexpr uint32_t kSplitPaths = 1000;  ///< figure B.1's setting
constexpr double kSplitRadiusMetres = 1.0;

/// --quick draws the outer rows and columns and the middle.
bool isDrawn(const BenchCall& call, const PrintedCosts& row, size_t radius) {
    if (!call.quick) return true;
    const bool path = row.paths == 500 || row.paths == kSplitPaths || row.paths == 7500;
    return path && radius % 2 == 0;
}

/// The cost split of each pipeline, a bar a scene.
using Splits = std::map<std::string, plot::StackedBars>;

std::vector<std::string> cellsOf(const PrintedCosts& printed, size_t radius, const Row& row) {
    std::vector<std::string> cells{fmt::format("{}", printed.paths),
                                   fmt::format("{:.2f}", kRadiiMetres[radius])};
    for (const char* pipeline : {"thesis", "full"}) {
        const Figures& figures = row.at(pipeline);
        cells.push_back(fmt::format("{:.0f}", figures.at(kStored).mean));
        cells.push_back(fmt::format("{:.1f}", figures.at(kFrame).mean));
        cells.push_back(fmt::format("{:.2f}", figures.at(kFrame).stddev));
    }
    cells.push_back(fmt::format("{}", printed.stored));
    cells.push_back(fmt::format("{:.1f}", printed.costs[radius].milliseconds));
    cells.push_back(fmt::format("{:.2f}", printed.costs[radius].stddev));
    return cells;
}

core::Result<void> addRow(Study& study, std::vector<Contestant>& both, const PrintedCosts& printed,
                          size_t radius, Table& table, Splits& splits) {
    for (Contestant& c : both) {
        c.options.photons = printed.paths;
        c.options.radius = static_cast<float>(kRadiiMetres[radius]);
    }
    const std::string scene = both.front().options.scene;
    study.progress =
        fmt::format("{}, {} paths, radius {}, frame", scene, printed.paths, kRadiiMetres[radius]);
    TRY(const Row row, study.race(both, nullptr));
    table.rows.push_back(cellsOf(printed, radius, row));
    if (printed.paths != kSplitPaths || kRadiiMetres[radius] != kSplitRadiusMetres) return {};
    for (auto& [pipeline, bars] : splits) bars.bars.push_back(costBar(scene, "", row.at(pipeline)));
    return {};
}

core::Result<void> measure(Study& study, const PrintedScene& printed, const std::string& scene,
                           Splits& splits) {
    Table table{std::filesystem::path(scene).stem().string(),
                fmt::format("Scene complexity (table {}, {}): {}", printed.table, printed.name,
                            study.about(scene)),
                {"paths", "radius m", "thesis stored", "thesis ms", "σ thesis ms", "full stored",
                 "full ms", "σ full ms", "paper stored", "paper ms", "σ paper ms"},
                {}};
    std::vector<Contestant> both{study.contestant(Pipeline::Thesis, scene),
                                 study.contestant(Pipeline::Full, scene)};
    for (const PrintedCosts& row : printed.rows)
        for (size_t radius = 0; radius < kRadiiMetres.size(); ++radius)
            if (isDrawn(study.call(), row, radius))
                TRY_VOID(addRow(study, both, row, radius, table, splits));
    return study.publish(table);
}

/// The four scenes, or the one asked for, beside the table of the scene that it stands for.
std::vector<PrintedScene> scenesOf(const BenchCall& call) {
    const auto tables = tablesB();
    if (call.scene.empty()) return {tables.begin(), tables.end()};
    const auto found = std::find_if(tables.begin(), tables.end(),
                                    [&](const PrintedScene& s) { return call.scene == s.builtin; });
    return {found == tables.end() ? tables.front() : *found};
}

}  // namespace

core::Result<void> benchSceneComplexity(const BenchCall& call) {
    TRY(Study study, Study::open(call, "scene-complexity", kQuick));
    const std::string setting =
        fmt::format("{} paths, radius {:.1f} m", kSplitPaths, kSplitRadiusMetres);
    Splits splits{{"thesis", costBars("thesis: " + setting)},
                  {"full", costBars("full: " + setting)}};
    for (const PrintedScene& printed : scenesOf(call)) {
        const std::string scene = call.scene.empty() ? printed.builtin : call.scene;
        TRY_VOID(measure(study, printed, scene, splits));
    }
    const std::vector<plot::StackedBars> panels{splits.at("thesis"), splits.at("full")};
    return study.publishPlot("costs", plot::sideBySide(panels));
}

}  // namespace lampyris::sandbox
