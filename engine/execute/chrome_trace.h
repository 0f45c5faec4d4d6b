/// \file Node times in Chrome's trace format (chrome://tracing, ui.perfetto.dev).
#pragma once

#include <string>
#include <vector>

#include "execute/statistics.h"

namespace lampyris::execute {

/// Nodes as "complete" events in microseconds, on one row for the device and one for the CPU's
/// recording. Nodes run one after the other; frames are laid end to end.
class ChromeTrace {
 public:
    void add(const FrameStatistics& frame);
    /// JSON text.
    [[nodiscard]] std::string text() const;

 private:
    std::vector<FrameStatistics> frames_;
};

}  // namespace lampyris::execute
