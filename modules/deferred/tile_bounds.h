/// \file tile bounds: least and greatest view depth of every 8 × 8 tile of pixels.
///   in  depth    out  vec2 a tile in metres; least above greatest where it shows no surface
///   shader deferred/tile_bounds.comp
#pragma once

#include "deferred/gbuffer.h"

namespace lampyris::deferred {

struct TileBounds {
    graph::Buffer bounds{};  ///< vec2 a tile, row by row
};

[[nodiscard]] TileBounds addTileBounds(graph::Frame& frame, const Surface& surface);

}  // namespace lampyris::deferred
