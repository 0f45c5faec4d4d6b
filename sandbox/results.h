/// \file The files beside the picture: report, graph, trace.
#pragma once

#include "execute/chrome_trace.h"
#include "report.h"

namespace lampyris::sandbox {

/// Writes what the options name; warns of validation messages.
core::Result<void> writeResults(const Options& options, FrameLoop& loop, const Measured& measured,
                                const execute::ChromeTrace& trace);

}  // namespace lampyris::sandbox
