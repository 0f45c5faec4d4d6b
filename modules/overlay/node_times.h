/// \file What the last frames' nodes cost: series, medians and 95th percentiles. No ImGui.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "execute/statistics.h"

namespace lampyris::overlay {

/// A node, or all parts of one, over the frames that are kept. Milliseconds.
struct NodeRow {
    std::string name;
    std::vector<float> gpu, cpuRecord;  ///< a frame each, the oldest first; 0 where it did not run
    float gpuMedian = 0.0f, gpuP95 = 0.0f, cpuMedian = 0.0f;
};

class NodeTimes {
 public:
    static constexpr size_t kFrames = 240;

    /// \param partsApart  each part of a node ("tile_bin/count") is a row; else one a node
    explicit NodeTimes(bool partsApart = false) : partsApart_(partsApart) {}

    void add(const execute::FrameStatistics& frame);
    void setPartsApart(bool apart);
    /// Forgets all frames.
    void clear();
    [[nodiscard]] bool partsApart() const { return partsApart_; }

    [[nodiscard]] const std::deque<execute::FrameStatistics>& frames() const { return frames_; }
    /// In the order of the last frame; nodes that only earlier frames had stand at the end, as long
    /// as one of the frames that are kept has them.
    [[nodiscard]] const std::vector<NodeRow>& rows() const { return rows_; }
    /// The whole frame's row, of device time from its first timestamp to its last. Medians and p95
    /// are of every eighth frame.
    [[nodiscard]] const NodeRow& whole() const { return whole_; }
    /// A line a node: name, median and p95 of device ms, median of recording ms.
    [[nodiscard]] std::string csv() const;

 private:
    void append(const execute::FrameStatistics& frame);
    void place(const execute::FrameStatistics& frame);
    void rebuild();
    void dropLeft();
    void summarise();

    std::deque<execute::FrameStatistics> frames_;
    std::vector<NodeRow> rows_;
    std::vector<size_t> places_;  ///< in rows_, of the last frame's nodes
    NodeRow whole_{"frame", {}, {}};
    size_t present_ = 0;       ///< the first rows_, which the last frame has
    size_t unsummarised_ = 0;  ///< frames since the last medians
    bool partsApart_;
};

}  // namespace lampyris::overlay
