#include "overlay/node_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace lampyris::overlay {
namespace {

constexpr size_t kSummaryFrames = 8;  // [chosen] medians move slowly, and cost 0.3 ms

/// Between two ranks it is interpolated, as in reports.
float quantile(std::vector<float> values, float share) {
    if (values.empty()) return 0.0f;
    const float rank = share * static_cast<float>(values.size() - 1);
    const auto below = static_cast<ptrdiff_t>(rank);
    std::nth_element(values.begin(), values.begin() + below, values.end());
    const float lower = values[static_cast<size_t>(below)];
    if (below + 1 >= static_cast<ptrdiff_t>(values.size())) return lower;
    const float upper = *std::min_element(values.begin() + below + 1, values.end());
    return lower + (upper - lower) * (rank - std::floor(rank));
}

bool sameNodes(const execute::FrameStatistics& a, const execute::FrameStatistics& b) {
    return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                      [](const auto& x, const auto& y) { return x.name == y.name; });
}

void summarise(NodeRow& row) {
    row.gpuMedian = quantile(row.gpu, 0.5f);
    row.gpuP95 = quantile(row.gpu, 0.95f);
    row.cpuMedian = quantile(row.cpuRecord, 0.5f);
}

}  // namespace

void NodeTimes::add(const execute::FrameStatistics& frame) {
    const bool alike = !frames_.empty() && sameNodes(frames_.back(), frame);
    frames_.push_back(frame);
    if (frames_.size() > kFrames) frames_.pop_front();
    if (!alike) place(frame);
    append(frame);
    dropLeft();
    if (++unsummarised_ >= kSummaryFrames || frames_.size() <= kSummaryFrames) summarise();
}

void NodeTimes::setPartsApart(bool apart) {
    if (apart == partsApart_) return;
    partsApart_ = apart;
    rebuild();
}

void NodeTimes::append(const execute::FrameStatistics& frame) {
    const auto push = [](std::vector<float>& series, double value) {
        if (series.size() == kFrames) series.erase(series.begin());
        series.push_back(static_cast<float>(value));
    };
    for (NodeRow& row : rows_) {
        push(row.gpu, 0.0);
        push(row.cpuRecord, 0.0);
    }
    double recorded = 0.0;
    for (size_t i = 0; i < frame.nodes.size(); ++i) {
        NodeRow& row = rows_[places_[i]];
        row.gpu.back() += static_cast<float>(frame.nodes[i].gpuMilliseconds);
        row.cpuRecord.back() += static_cast<float>(frame.nodes[i].cpuRecordMilliseconds);
        recorded += frame.nodes[i].cpuRecordMilliseconds;
    }
    push(whole_.gpu, frame.gpuMilliseconds);
    push(whole_.cpuRecord, recorded);
}

/// Finds or makes a row for each node, and puts these first.
void NodeTimes::place(const execute::FrameStatistics& frame) {
    std::unordered_map<std::string, size_t> byName;
    std::vector<NodeRow> rows;
    places_.clear();
    for (const execute::NodeTime& node : frame.nodes) {
        const std::string name = partsApart_ ? node.name : execute::reportedName(node.name);
        const auto [found, isNew] = byName.emplace(name, rows.size());
        places_.push_back(found->second);
        if (!isNew) continue;
        const auto known = std::find_if(rows_.begin(), rows_.end(),
                                        [&](const NodeRow& row) { return row.name == name; });
        if (known == rows_.end()) {
            const std::vector<float> none(whole_.gpu.size());
            rows.push_back({name, none, none});
        } else {
            rows.push_back(std::move(*known));
            rows_.erase(known);
        }
    }
    present_ = rows.size();
    std::move(rows_.begin(), rows_.end(), std::back_inserter(rows));
    rows_ = std::move(rows);
}

/// Rows of nodes that no frame has any more.
void NodeTimes::dropLeft() {
    const auto isZero = [](float value) { return value == 0.0f; };
    const auto left = rows_.begin() + static_cast<ptrdiff_t>(present_);
    rows_.erase(std::remove_if(left, rows_.end(),
                               [&](const NodeRow& row) {
                                   return std::all_of(row.gpu.begin(), row.gpu.end(), isZero) &&
                                          std::all_of(row.cpuRecord.begin(), row.cpuRecord.end(),
                                                      isZero);
                               }),
                rows_.end());
}

void NodeTimes::clear() {
    *this = NodeTimes(partsApart_);
}

void NodeTimes::rebuild() {
    rows_.clear();
    whole_ = {"frame", {}, {}};
    for (const execute::FrameStatistics& frame : frames_) {
        place(frame);
        append(frame);
    }
    dropLeft();
    summarise();
}

void NodeTimes::summarise() {
    unsummarised_ = 0;
    for (NodeRow& row : rows_) overlay::summarise(row);
    overlay::summarise(whole_);
}

std::string NodeTimes::csv() const {
    std::string text = "node,gpu_ms_median,gpu_ms_p95,cpu_record_ms_median\n";
    const auto line = [&](const NodeRow& row) {
        text += fmt::format("{},{:.4f},{:.4f},{:.4f}\n", row.name, row.gpuMedian, row.gpuP95,
                            row.cpuMedian);
    };
    for (const NodeRow& row : rows_) line(row);
    line(whole_);
    return text;
}

}  // namespace lampyris::overlay
