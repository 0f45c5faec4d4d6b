#include "deferred/tile_bounds.h"

#include "deferred/shaders.h"
#include "deferred/view.h"
#include "shared/direct.h"
#include "shared/surface.h"

namespace lampyris::deferred {

TileBounds addTileBounds(graph::Frame& frame, const Surface& surface) {
    const uint32_t tiles = tileCount(surface.view);
    auto node = frame.compute("sphere_direct/bounds", shaders::tileBounds);
    node.sample(shared::SLOT_SURFACE_DEPTH, surface.depth)
        .uniformData(shared::SLOT_VIEW, surface.view);
    TileBounds result{
        node.write(shared::SLOT_TILE_BOUNDS, frame.buffer("tile bounds", {uint64_t{tiles} * 8}))};
    node.dispatch((tiles + 63) / 64);
    return result;
}

}  // namespace lampyris::deferred
