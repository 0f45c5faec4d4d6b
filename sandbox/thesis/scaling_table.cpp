#include "thesis/scaling_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace lampyris::sandbox::thesis {
namespace {

std::vector<std::string> cellsOf(const ScalingRow& row) {
    const Figures& here = row.here;
    const auto cell = [&](const char* name, int digits) {
        return fmt::format("{:.{}f}", here.at(name).mean, digits);
    };
    const auto spread = [&](const char* name, int digits) {
        return fmt::format("{:.{}f}", here.at(name).stddev, digits);
    };
    const PrintedRow& p = row.printed;
    return {cell(kPaths, 0),
            fmt::format("{:.2f}", row.radiusMetres),
            cell(kStored, 0),
            cell(kFrame, 1),
            spread(kFrame, 2),
            cell("MSE", 2),
            spread("MSE", 2),
            cell("NRMSE", 4),
            cell("MSSIM", 4),
            spread("MSSIM", 4),
            cell("FLIP", 4),
            fmt::format("{}", p.paths),
            fmt::format("{}", p.stored),
            fmt::format("{:.1f}", p.milliseconds),
            fmt::format("{:.2f}", p.stddev),
            fmt::format("{:.2f}", p.mse),
            fmt::format("{:.4f}", p.nrmse),
            fmt::format("{:.4f}", p.mssim)};
}

}  // namespace

Table scalingTable(const std::string& name, const std::string& title,
                   const std::vector<ScalingRow>& rows) {
    Table table{name,
                title,
                {"paths", "radius m", "stored", "ms", "σ ms", "MSE", "σ MSE", "NRMSE", "MSSIM",
                 "σ MSSIM", "FLIP", "paper paths", "stored", "ms", "σ ms", "MSE", "NRMSE", "MSSIM"},
                {}};
    for (size_t i = 12; i < table.header.size(); ++i) table.header[i].insert(0, "paper ");
    for (const ScalingRow& row : rows) table.rows.push_back(cellsOf(row));
    return table;
}

plot::Chart chartOverRadius(const std::string& title, const std::string& yLabel, plot::Scale yScale,
                            const std::vector<ScalingSample>& samples) {
    plot::Chart chart{title, "radius (m)", yLabel, yScale, {}};
    for (const ScalingSample& sample : samples) {
        const std::string name = fmt::format("{} paths", sample.paths);
        auto series = std::find_if(chart.series.begin(), chart.series.end(),
                                   [&](const plot::Series& s) { return s.name == name; });
        if (series == chart.series.end())
            series = chart.series.insert(series, plot::Series{name, {}});
        series->points.push_back({sample.radiusMetres, sample.value});
    }
    return chart;
}

}  // namespace lampyris::sandbox::thesis
