// `lampyris bench parameter-scaling`: the Thesis' table 6.1, cost and error over paths and radius.
#include <algorithm>
#include <functional>

#include "thesis/scaling_table.h"
#include "thesis/truth.h"

namespace lampyris::sandbox {
namespace {

using namespace thesis;
using photon_gi::Pipeline;

/// What the plots show, here and in the Thesis.
struct Shown {
    const char* name;
    const char* label;
    plot::Scale scale;
    std::function<double(const Figures&)> here;
    std::function<double(const PrintedRow&)> printed;
};

std::vector<Shown> shownFigures() {
    return {
        {"ms", "GPU time of a frame (ms)", plot::Scale::Logarithmic,
         [](const Figures& f) { return f.at(kFrame).mean; },
         [](const PrintedRow& p) { return p.milliseconds; }},
        {"mse", "MSE", plot::Scale::Logarithmic, [](const Figures& f) { return f.at("MSE").mean; },
         [](const PrintedRow& p) { return p.mse; }},
        {"mssim", "MSSIM", plot::Scale::Linear, [](const Figures& f) { return f.at("MSSIM").mean; },
         [](const PrintedRow& p) { return p.mssim; }}};
}

/// The Thesis first, then each way of drawing; errors of all on one scale.
std::string panelsOf(const Shown& shown,
                     const std::map<std::string, std::vector<ScalingRow>>& all) {
    std::map<std::string, std::vector<ScalingSample>> samples;
    for (const PrintedRow& p : table61())
        samples["the Thesis"].push_back({p.paths, p.radiusMetres, shown.printed(p)});
    for (const auto& [name, rows] : all)
        for (const ScalingRow& row : rows)
            samples[name].push_back({row.printed.paths, row.radiusMetres, shown.here(row.here)});
    std::vector<plot::Chart> panels;
    std::vector<double> values;
    for (const char* name : {"the Thesis", "thesis", "full"}) {
        panels.push_back(chartOverRadius(name, shown.label, shown.scale, samples.at(name)));
        for (const ScalingSample& sample : samples.at(name)) values.push_back(sample.value);
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    for (plot::Chart& panel : panels)
        if (shown.name != std::string("ms")) panel.y = plot::Range{*least, *most};
    return plot::sideBySide(panels);
}

core::Result<void> publishAll(const Study& study, const Truth& truth,
                              const std::map<std::string, std::vector<ScalingRow>>& all) {
    for (const Pipeline pipeline : {Pipeline::Thesis, Pipeline::Full}) {
        const Options& options = study.contestant(pipeline, study.scene()).options;
        const auto title =
            fmt::format("Parameter scaling (table 6.1): {}; {}; errors of the last {} against {}",
                        describe(sandbox::settingsOf(options)), study.about(study.scene()),
                        study.size().judged, truth.about);
        TRY_VOID(study.publish(scalingTable(name(pipeline), title, all.at(name(pipeline)))));
    }
    for (const Shown& shown : shownFigures())
        TRY_VOID(study.publishPlot(shown.name, panelsOf(shown, all)));
    return {};
}

}  // namespace

core::Result<void> benchParameterScaling(const BenchCall& call) {
    TRY(Study study, Study::open(call, "parameter-scaling"));
    TRY(const Truth truth, findTruth(study, study.scene()));
    std::vector<Contestant> both{study.contestant(Pipeline::Thesis, study.scene()),
                                 study.contestant(Pipeline::Full, study.scene())};
    std::map<std::string, std::vector<ScalingRow>> all;
    for (size_t i = 0; i < table61().size(); ++i) {
        const PrintedRow& printed = table61()[i];
        for (Contestant& c : both) {
            c.options.photons = printed.paths;
            c.options.radius = static_cast<float>(printed.radiusMetres);
        }
        study.progress = fmt::format("row {}/{}, frame", i + 1, table61().size());
        TRY(const Row row, study.race(both, &truth));
        for (const auto& [name, figures] : row)
            all[name].push_back({printed, printed.radiusMetres, figures});
    }
    return publishAll(study, truth, all);
}

}  // namespace lampyris::sandbox
