#include "frame_series.h"

#include <algorithm>
#include <cmath>

namespace lampyris::sandbox {
namespace {

constexpr double kAgreement =
    0.1;  // share of the frame by which the nodes' sum may miss it [DESIGN.md]

bool matches(const std::string& name, const std::string& pattern) {
    if (!pattern.ends_with('*')) return name == pattern;
    return name.starts_with(pattern.substr(0, pattern.size() - 1));
}

}  // namespace

FrameSeries::Node& FrameSeries::nodeNamed(const std::string& name) {
    const auto found =
        std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& n) { return n.name == name; });
    if (found != nodes_.end()) return *found;
    const std::vector<double> none(frames(), 0.0);
    return nodes_.emplace_back(Node{name, none, none});
}

void FrameSeries::list(const execute::FrameStatistics& frame) {
    for (const execute::NodeTime& time : frame.nodes) nodeNamed(execute::reportedName(time.name));
}

void FrameSeries::add(const execute::FrameStatistics& frame) {
    frameMilliseconds_.push_back(frame.gpuMilliseconds);
    for (const execute::NodeTime& time : frame.nodes) nodeNamed(execute::reportedName(time.name));
    for (Node& node : nodes_) {
        node.gpu.resize(frames(), 0.0);
        node.cpu.resize(frames(), 0.0);
    }
    for (const execute::NodeTime& time : frame.nodes) {
        Node& node = nodeNamed(execute::reportedName(time.name));
        node.gpu.back() += time.gpuMilliseconds;
        node.cpu.back() += time.cpuRecordMilliseconds;
    }
}

std::vector<double> FrameSeries::gpuMilliseconds(const std::string& name) const {
    for (const Node& node : nodes_)
        if (node.name == name) return node.gpu;
    return {};
}

std::vector<double> FrameSeries::sumOf(std::span<const std::string> names) const {
    std::vector<double> sums(frames(), 0.0);
    for (const Node& node : nodes_) {
        const auto isNode = [&](const std::string& pattern) { return matches(node.name, pattern); };
        if (std::none_of(names.begin(), names.end(), isNode)) continue;
        for (size_t i = 0; i < sums.size(); ++i) sums[i] += node.gpu[i];
    }
    return sums;
}

std::vector<NodeSummary> FrameSeries::summariseNodes() const {
    std::vector<NodeSummary> summaries;
    std::vector<double> rest = frameMilliseconds_;
    for (const Node& node : nodes_) {
        summaries.push_back({node.name, summarise(node.gpu), summarise(node.cpu)});
        for (size_t i = 0; i < rest.size(); ++i) rest[i] -= node.gpu[i];
    }
    const Statistics other = summarise(rest);
    if (std::abs(other.mean) > kAgreement * summarise(frameMilliseconds_).mean)
        summaries.push_back({"other", other, {}});
    return summaries;
}

}  // namespace lampyris::sandbox
