#include "flicker/output.h"

#include <functional>
#include <nlohmann/json.hpp>

#include "evaluation/heat_map.h"
#include "plot/chart.h"
#include "report.h"

namespace lampyris::sandbox::flicker {
namespace {

using evaluation::Lag;
using Json = nlohmann::ordered_json;

constexpr float kBrightest = 16.0f;  // [chosen] of 255: what trembles more disturbs anyhow

struct Sequence {
    const char* name;
    const std::vector<double>* values;
    size_t first = 0;  ///< frame of the first value
};

std::vector<Sequence> sequencesOf(const Row& row) {
    std::vector<Sequence> all{{"still", &row.still.changes}, {"frozen", &row.frozen.changes}};
    if (row.moving) {
        all.push_back({"moving", &row.moving->changes, 1});
        all.push_back({"floor", &row.floor.changes, 1});
    }
    for (size_t i = 0; i < row.lags.size(); ++i)
        if (row.lags[i]) all.push_back({kLightChanges[i], &row.lags[i]->differences});
    return all;
}

std::string lagCell(const std::optional<Lag>& lag) {
    if (!lag) return "–";
    const std::string frames = lag->frames ? fmt::format("{}", *lag->frames)
                                           : fmt::format("> {}", evaluation::kLagSettled - 1);
    return fmt::format("{} ({:.1f} %)", frames, 100.0 * lag->rest);
}

std::string movingCell(const Row& row) {
    if (!row.moving) return "void: nothing moves";
    if (!row.moving->valid(row.floor.value)) return "void: floor too high";
    return fmt::format("{:.3f}", row.moving->value);
}

Json toJson(const Still& still) {
    return {{"mean", still.flicker.mean},
            {"p99", still.flicker.percentile99},
            {"mssim_of_mean", still.mssim},
            {"changes", still.changes}};
}

Json lagsJson(const Row& row) {
    Json lags;
    for (size_t i = 0; i < row.lags.size(); ++i) {
        const auto& lag = row.lags[i];
        Json& json = lags[kLightChanges[i]] = nullptr;
        if (lag)
            json = {{"frames", lag->frames ? Json(*lag->frames) : Json(nullptr)},
                    {"rest", lag->rest},
                    {"differences", lag->differences}};
    }
    return lags;
}

Json movingJson(const Row& row) {
    if (!row.moving) return nullptr;
    return {{"value", row.moving->value},
            {"floor", row.floor.value},
            {"valid", row.moving->valid(row.floor.value)},
            {"changes", row.moving->changes},
            {"floor_changes", row.floor.changes}};
}

plot::Chart chartOf(const std::vector<Row>& rows, const std::string& sequence,
                    const std::string& title, const std::string& label) {
    plot::Chart chart{title, "frame", label, plot::Scale::Linear, {}, plot::Range{0.0, 1.0}};
    for (const Row& row : rows)
        for (const Sequence& found : sequencesOf(row)) {
            if (found.name != sequence) continue;
            plot::Series series{row.name, {}};
            series.markers = false;
            for (size_t i = 0; i < found.values->size(); ++i)
                series.points.push_back({static_cast<double>(i + found.first), (*found.values)[i]});
            chart.series.push_back(std::move(series));
        }
    return chart;
}

}  // namespace

Table tableOf(const Call& call, const std::vector<Row>& rows) {
    const graph::Extent size = call.stillSize();
    Table table{
        "flicker",
        fmt::format("Flicker: {}, {}x{}, {} frames after {}, exposure {:g}, on {}; luma of 255, "
                    "lag in frames (what flicker leaves of the change)",
                    call.options.scene, size.width, size.height, call.stillFrames(), call.warmup(),
                    call.options.display.exposureEv, rows.empty() ? "" : rows[0].device),
        {"pipeline", "static", "p99", "dynamic", "floor", "lag off", "lag on", "lag moved",
         "MSSIM of the mean", "frozen", "frozen MSSIM"},
        {}};
    for (const Row& row : rows)
        table.rows.push_back(
            {row.name, fmt::format("{:.3f}", row.still.flicker.mean),
             fmt::format("{:.2f}", row.still.flicker.percentile99), movingCell(row),
             row.moving ? fmt::format("{:.3f}", row.floor.value) : "–", lagCell(row.lags[0]),
             lagCell(row.lags[1]), lagCell(row.lags[2]), fmt::format("{:.4f}", row.still.mssim),
             fmt::format("{:.3f}", row.frozen.flicker.mean),
             fmt::format("{:.4f}", row.frozen.mssim)});
    return table;
}

core::DisplayImage mapOf(const std::vector<Row>& rows) {
    std::vector<core::DisplayImage> maps;
    maps.reserve(rows.size());
    for (const Row& row : rows)
        maps.push_back(evaluation::heatMap(row.still.flicker.map, kBrightest));
    return evaluation::sideBySide(maps);
}

std::string csvOf(const std::vector<Row>& rows) {
    std::string text = "row,sequence,frame,value\n";
    for (const Row& row : rows)
        for (const Sequence& sequence : sequencesOf(row))
            for (size_t i = 0; i < sequence.values->size(); ++i)
                text += fmt::format("\"{}\",{},{},{:.6g}\n", row.name, sequence.name,
                                    i + sequence.first, (*sequence.values)[i]);
    return text;
}

std::string plotOf(const std::vector<Row>& rows) {
    std::vector<plot::Chart> charts{
        chartOf(rows, "still", "nothing moves", "mean change of luma"),
        chartOf(rows, "off", "light off", "mean difference of luma"),
        chartOf(rows, "on", "light on", "mean difference of luma"),
        chartOf(rows, "moved", "light moved", "mean difference of luma")};
    const bool moving = std::any_of(rows.begin(), rows.end(),
                                    [](const Row& row) { return row.moving.has_value(); });
    if (moving)
        charts.insert(charts.begin() + 1,
                      chartOf(rows, "moving", "in motion", "mean change not of the motion"));
    return plot::sideBySide(charts);
}

std::string reportOf(const Call& call, const std::vector<Row>& rows) {
    const graph::Extent size = call.stillSize();
    const graph::Extent moving = call.movingSize();
    Json report{{"scene", call.options.scene},
                {"device", rows.empty() ? "" : rows[0].device},
                {"size", {size.width, size.height}},
                {"frames", call.stillFrames()},
                {"warmup", call.warmup()},
                {"dynamic_size", {moving.width, moving.height}},
                {"dynamic_frames", call.movingFrames()},
                {"timestep", call.timestep()}};
    report["rows"] = Json::array();
    for (const Row& row : rows)
        report["rows"].push_back({{"name", row.name},
                                  {"pipeline", name(row.options.pipeline)},
                                  {"settings", settingsJson(row.options)},
                                  {"static", toJson(row.still)},
                                  {"dynamic", movingJson(row)},
                                  {"lag", lagsJson(row)},
                                  {"frozen", toJson(row.frozen)}});
    return report.dump(2) + "\n";
}

}  // namespace lampyris::sandbox::flicker
