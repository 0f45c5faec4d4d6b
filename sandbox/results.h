/// \file The files beside the picture: report, graph, trace.
#pragma once

#include "report.h"
#include "trace.h"

namespace lampyris::sandbox {

/// Writes what the options name; warns of validation messages.
core::Result<void> writeResults(const Options& options, FrameLoop& loop, const Measured& measured,
                                const Trace& trace);

}  // namespace lampyris::sandbox
