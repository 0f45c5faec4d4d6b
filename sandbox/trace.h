/// \file Node times in Chrome's trace format (chrome://tracing, ui.perfetto.dev).
#pragma once

#include <string>
#include <vector>

#include "execute/statistics.h"

namespace lampyris::sandbox {

/// Nodes as "complete" events in microseconds, on one row for the device and one for the CPU's
/// recording. Nodes run one after the other; frames are laid end to end.
class Trace {
 public:
    void add(const execute::FrameStatistics& frame);
    /// JSON text.
    [[nodiscard]] std::string text() const;

 private:
    std::vector<execute::FrameStatistics> frames_;
};

}  // namespace lampyris::sandbox
