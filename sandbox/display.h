/// \file display: linear radiance to what a window shows; core::toDisplay on the device.
///   in      radiance      out   8-bit sRGB, in RGBA8Unorm
///   shader  sandbox/display.comp
#pragma once

#include "core/display.h"
#include "graph/frame.h"

namespace lampyris::sandbox {

[[nodiscard]] graph::Image addDisplay(graph::Frame& frame, graph::Image radiance,
                                      const core::DisplayTransform& transform);

}  // namespace lampyris::sandbox
