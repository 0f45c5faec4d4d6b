/// \file What a declaration must fulfil before anything is derived from it. Each error names node
/// and resource.
#pragma once

#include <vector>

#include "core/result.h"
#include "graph/frame.h"

namespace lampyris::graph {

/// All checks below, in this order: handles, sizes, slots.
[[nodiscard]] core::Result<void> verify(const Frame& frame,
                                        const std::vector<Frame::Output>& outputs);

/// Handles from nowhere, stale ones, reads before any write, and images wanted in two layouts by
/// one node.
[[nodiscard]] core::Result<void> verifyHandles(const Frame& frame,
                                               const std::vector<Frame::Output>& outputs);

/// Empty images and buffers, ranges outside their buffer, attachments of the wrong size or format,
/// and copies that do not fit.
[[nodiscard]] core::Result<void> verifySizes(const Frame& frame, const Node& node);

/// The node's declared slots against those that reflection found: each there, once, of its kind,
/// and written only where the node says so.
[[nodiscard]] core::Result<void> verifySlots(const Frame& frame, const Node& node);

}  // namespace lampyris::graph
