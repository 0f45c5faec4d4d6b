/// \file GPU timing: every node's milliseconds as bars and as history.
#pragma once

#include <filesystem>
#include <string>

#include "overlay/frame_seen.h"
#include "overlay/node_times.h"

namespace lampyris::overlay {

/// What a frame was drawn with: its times are not mixed with those of others.
struct TimedWith {
    photon_gi::Settings settings;
    graph::Extent size{};  ///< pixels
    bool operator==(const TimedWith&) const = default;
};

class TimingPanel {
 public:
    /// Remembers a frame that was drawn, and forgets those before it that were drawn with other
    /// settings; does nothing while frozen.
    void add(const execute::FrameStatistics& frame, double overlayMilliseconds,
             const TimedWith& with = {});
    /// \param open  as ImGui::Begin has it
    void draw(bool* open);

    float budgetMilliseconds = 16.7f;  ///< where the line stands
    /// Where "Chrome trace" writes to.
    std::filesystem::path traceFile = "lampyris_trace.json";
    [[nodiscard]] const NodeTimes& times() const { return times_; }
    /// The overlay's own CPU time, median of the frames that are kept; 0 before there were any.
    [[nodiscard]] float overlayMilliseconds() const;

 private:
    void clear();
    void drawButtons();
    void drawFrame();
    void drawNodes();
    void drawHistory();

    NodeTimes times_;
    TimedWith with_;  ///< all that is kept
    bool frozen_ = false;
    std::string selected_;  ///< node whose history is drawn; empty: the frame's
    std::string written_;   ///< what became of the last export
    std::vector<float> overlayCpu_;
};

}  // namespace lampyris::overlay
