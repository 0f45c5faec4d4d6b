// `lampyris bench system-comparison`: the Thesis' table 6.3. In place of three game engines:
// `full`, `thesis` with as many paths as `full`'s time affords, direct light with a constant
// ambient, and the CPU reference at equal time.
#include <algorithm>

#include "plot/stacked_bars.h"
#include "reference/reference.h"
#include "thesis/constant_ambient.h"
#include "thesis/equal_cost.h"
#include "thesis/printed.h"
#include "thesis/truth.h"

namespace lampyris::sandbox {
namespace {

using namespace thesis;
using photon_gi::Pipeline;

constexpr StudySize kQuick{{480, 270}, 8, 4, 256, 2};
constexpr const char* kSamples = "spp";
constexpr const char* kEqualTime = "thesis, equal time";
constexpr uint32_t kFirstGuess = 1000;  // paths, the Thesis' middle row

core::Result<core::Image> draw(const Study& study, const std::string& node) {
    Contestant direct = study.contestant(Pipeline::Direct, study.scene());
    direct.options.outputNode = node;
    TRY(FrameLoop* const loop, loopOf(direct));
    TRY(LoopFrame frame, loop->draw(0, true));
    return std::move(frame.outcome.image);
}

/// Direct light with the constant that fits the reference best; costs what `direct` costs.
core::Result<Row> measureAmbient(const Study& study, const Truth& truth, const Figures& direct) {
    TRY(const core::Image light, draw(study, "final"));
    TRY(const core::Image albedo, draw(study, "albedo"));
    const auto& display = study.call().options.display;
    const auto ambient = bestAmbient(light, albedo, truth.picture.display, display);
    const std::vector<core::Image> pictures{withAmbient(light, albedo, ambient)};
    TRY(Figures figures, errorsOf(pictures, truth.picture, display));
    figures[kFrame] = direct.at(kFrame);
    for (size_t c = 0; c < ambient.size(); ++c)
        figures[fmt::format("ambient_{}", "rgb"[c])] = {ambient[c], 0.0};
    return Row{{"ambient", figures}};
}

/// One picture of the CPU reference.
core::Result<reference::Rendered> trace(const Study& study, FrameLoop& loop, uint32_t samples,
                                        uint32_t seed) {
    reference::Settings settings;
    settings.width = study.size().size.width;
    settings.height = study.size().size.height;
    settings.samplesPerPixel = samples;
    settings.seed = seed;
    return reference::render(loop.snapshot(), loop.request.camera, settings);
}

/// As many samples as fit into the time of a frame of `full`; one at least.
core::Result<Row> measureReference(const Study& study, const Truth& truth, Contestant& full,
                                   double milliseconds) {
    TRY(FrameLoop* const loop, loopOf(full));
    TRY(const auto one, trace(study, *loop, 1, 1));
    const double fitting = milliseconds / (1000.0 * one.seconds);
    const auto samples = static_cast<uint32_t>(std::clamp(fitting, 1.0, 4096.0));
    std::vector<core::Image> pictures;
    std::vector<double> times;
    for (uint32_t i = 0; i < study.size().judged; ++i) {
        TRY(auto rendered, trace(study, *loop, samples, i + 2));
        times.push_back(1000.0 * rendered.seconds);
        pictures.push_back(std::move(rendered.final));
    }
    TRY(Figures figures, errorsOf(pictures, truth.picture, study.call().options.display));
    figures[kFrame] = spreadOf(times);
    figures[kSamples] = {static_cast<double>(samples), 0.0};
    return Row{{"reference", figures}};
}

/// `thesis` with the paths for which its whole frame costs what one of `full` does.
core::Result<Contestant> thesisAtEqualTime(Study& study) {
    Pair pair{{study.contestant(Pipeline::Full, study.scene()),
               study.contestant(Pipeline::Thesis, study.scene())}};
    pair.candidate().name = kEqualTime;
    study.progress = kEqualTime;
    TRY(pair.candidate().options.photons, pathsOfEqualCost(study, pair, Cost::Frame, kFirstGuess));
    study.progress = "frame";
    return std::move(pair.candidate());
}

struct System {
    std::string name;
    Figures figures;
};

core::Result<std::vector<System>> measure(Study& study, const Truth& truth) {
    std::vector<Contestant> raced;
    for (const Pipeline pipeline : {Pipeline::Thesis, Pipeline::Full, Pipeline::Direct})
        raced.push_back(study.contestant(pipeline, study.scene()));
    TRY(Contestant equal, thesisAtEqualTime(study));
    raced.push_back(std::move(equal));
    TRY(const Row row, study.race(raced, &truth));
    const nlohmann::json key{{"race", thesis::settingsOf(raced)}, {"truth", truth.id}};
    TRY(const Row ambient, study.row({{"ambient", key}}, [&] {
        return measureAmbient(study, truth, row.at("direct"));
    }));
    TRY(const Row traced, study.row({{"equal time", key}, {"judged", study.size().judged}}, [&] {
        return measureReference(study, truth, raced[1], row.at("full").at(kFrame).mean);
    }));
    const Figures& reference = traced.at("reference");
    const auto paths = [&](const char* name) {
        return fmt::format("thesis, {:.0f} paths", row.at(name).at(kPaths).mean);
    };
    return std::vector<System>{
        {paths("thesis"), row.at("thesis")},
        {paths(kEqualTime), row.at(kEqualTime)},
        {"full", row.at("full")},
        {"direct", row.at("direct")},
        {"direct + ambient", ambient.at("ambient")},
        {fmt::format("reference, {:.0f} spp", reference.at(kSamples).mean), reference}};
}

Table tableOf(const Study& study, const Truth& truth, const std::vector<System>& systems) {
    Table table{
        {},
        fmt::format("System comparison (table 6.3): {}; errors of the last {} against {}. "
                    "The Thesis' systems ran on its own machine and scene",
                    study.about(study.scene()), study.size().judged, truth.about),
        {"system", "ms", "σ ms", "MSE", "σ MSE", "NRMSE", "MSSIM", "σ MSSIM", "FLIP", "relMSE"},
        {}};
    for (const auto& [name, f] : systems) {
        const auto cell = [&, &figures = f](const char* figure, int digits) {
            return fmt::format("{:.{}f}", figures.at(figure).mean, digits);
        };
        table.rows.push_back(
            {name, cell(kFrame, 1), fmt::format("{:.2f}", f.at(kFrame).stddev), cell("MSE", 2),
             fmt::format("{:.2f}", f.at("MSE").stddev), cell("NRMSE", 4), cell("MSSIM", 4),
             fmt::format("{:.4f}", f.at("MSSIM").stddev), cell("FLIP", 4), cell("relMSE", 4)});
    }
    for (const PrintedSystem& p : table63())
        table.rows.push_back({fmt::format("paper: {}", p.name),
                              fmt::format("{:.1f}", p.milliseconds), "–",
                              fmt::format("{:.2f}", p.mse), "–", fmt::format("{:.4f}", p.nrmse),
                              fmt::format("{:.4f}", p.mssim), "–", "–", "–"});
    return table;
}

std::string plotOf(const std::vector<System>& systems) {
    const std::vector<std::pair<const char*, const char*>> shown{
        {kFrame, "time (ms)"}, {"MSE", "MSE"}, {"FLIP", "FLIP"}};
    std::vector<plot::StackedBars> panels;
    for (const auto& [figure, label] : shown) {
        plot::StackedBars bars{label, label, {label}, {}};
        for (const System& system : systems) {
            const size_t space = system.name.find(' ');
            bars.bars.push_back({system.name.substr(0, space),
                                 space == std::string::npos ? "" : system.name.substr(space + 1),
                                 {system.figures.at(figure).mean}});
        }
        panels.push_back(bars);
    }
    return plot::sideBySide(panels);
}

}  // namespace

core::Result<void> benchSystemComparison(const BenchCall& call) {
    TRY(Study study, Study::open(call, "system-comparison", kQuick));
    TRY(const Truth truth, findTruth(study, study.scene()));
    TRY(const auto systems, measure(study, truth));
    TRY_VOID(study.publish(tableOf(study, truth, systems)));
    return study.publishPlot("errors", plotOf(systems));
}

}  // namespace lampyris::sandbox
