/// \file show: the G-buffer as images to look at. Published under albedo, normal, position, depth
/// and emission; the graph culls those that nobody asks for.
#pragma once

#include "deferred/gbuffer.h"

namespace lampyris::deferred {

void publishSurface(graph::Frame& frame, const Surface& surface);

}  // namespace lampyris::deferred
