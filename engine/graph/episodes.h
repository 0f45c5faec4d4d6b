/// \file The life of each resource within a frame, as episodes between which barriers stand.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::graph {

/// Touches that need no barrier between each other: one writing step, or all reads in one layout up
/// to the next write. `firstStep` may be steps.size(): what comes after the frame.
struct Episode {
    uint32_t firstStep = 0;
    uint32_t lastStep = 0;
    TouchSet touches{};
    Layout layout = Layout::Undefined;  ///< images
    bool writes = false;
    bool discards = false;  ///< does not need what was there
};

/// Of one resource, in order; empty where nothing touches it.
using Episodes = std::vector<Episode>;

/// An Episodes per resource of the frame. What is still needed after the frame is an episode of its
/// own or part of the last one: imported → importedAs, history → Sampled, transient outputs →
/// TransferRead.
[[nodiscard]] std::vector<Episodes> findEpisodes(const Frame& frame, const std::vector<Step>& steps,
                                                 const std::vector<Frame::Output>& outputs);

/// The layout an image has when the frame begins.
[[nodiscard]] Layout openingLayout(const ResourceInfo& info);

/// The steps: one a node, and where `poison` is set one before each first touch of transients.
[[nodiscard]] std::vector<Step> makeSteps(const Frame& frame, const std::vector<uint32_t>& nodes,
                                          bool poison);

}  // namespace lampyris::graph
