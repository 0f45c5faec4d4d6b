/// \file Legal frames made at random: all kinds of nodes, resources and accesses.
#pragma once

#include <cstdint>

#include "graph/frame.h"
#include "support/matching_shaders.h"

namespace lampyris::tests {

/// The same seed gives the same frame.
struct RandomFrame {
    explicit RandomFrame(uint64_t seed);
    graph::Frame frame;
    MatchingShaders shaders;
};

}  // namespace lampyris::tests
