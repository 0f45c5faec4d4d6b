/// \file Times of several frames, collected a node.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "execute/statistics.h"
#include "statistics.h"

namespace lampyris::sandbox {

struct NodeSummary {
    std::string name;
    Statistics gpuMilliseconds;
    Statistics cpuRecordMilliseconds;
};

class FrameSeries {
 public:
    void add(const execute::FrameStatistics& frame);
    /// A frame that is not measured: its nodes are listed, if only with zeros.
    void list(const execute::FrameStatistics& frame);

    [[nodiscard]] size_t frames() const { return frameMilliseconds_.size(); }
    /// Device milliseconds from a frame's first timestamp to its last.
    [[nodiscard]] const std::vector<double>& frameMilliseconds() const {
        return frameMilliseconds_;
    }
    /// A node's share in each frame; zeros in frames without it, empty where no frame has it.
    [[nodiscard]] std::vector<double> gpuMilliseconds(const std::string& name) const;
    /// What the named nodes took together in each frame; a name that ends in '*' stands for all
    /// that begin so.
    [[nodiscard]] std::vector<double> sumOf(std::span<const std::string> names) const;
    /// In the order of the frame. Where the nodes' sum and the frame differ by more than a tenth,
    /// the difference stands as a last node `other`.
    [[nodiscard]] std::vector<NodeSummary> summariseNodes() const;

 private:
    struct Node {
        std::string name;
        std::vector<double> gpu, cpu;  ///< a frame each
    };
    Node& nodeNamed(const std::string& name);

    std::vector<double> frameMilliseconds_;
    std::vector<Node> nodes_;
};

}  // namespace lampyris::sandbox
