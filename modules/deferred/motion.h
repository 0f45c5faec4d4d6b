/// \file gbuffer_motion: how far every pixel's surface moved since the frame before.
///   in      surface's depth, draws that moved      out   metres, world space; a = 1 where it moved
///   shader  deferred/motion.vert, .frag
#pragma once

#include <vector>

#include "deferred/gbuffer.h"

namespace lampyris::deferred {

/// The position before minus the position now, RGBA16F, 0 where nothing moved. Invalid, and no node
/// at all, where none of the draws moved. \param draws that `surface` was drawn with
[[nodiscard]] graph::Image addMotion(graph::Frame& frame, const Surface& surface,
                                     const residency::SceneHandles& scene,
                                     const std::vector<residency::DrawItem>& draws);

}  // namespace lampyris::deferred
