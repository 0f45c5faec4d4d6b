/// \file The camera of a frame as shaders see it.
#pragma once

#include "graph/resource.h"
#include "scene/snapshot.h"
#include "shared/view.h"

namespace lampyris::deferred {

/// Rays go through pixel centres; depth is reversed with the far plane at infinity.
[[nodiscard]] shared::View makeView(const scene::SnapshotCamera& camera, graph::Extent size);

/// Number of 8 × 8 tiles, whole or cut.
[[nodiscard]] inline uint32_t tileCount(const shared::View& view) {
    return view.tilesX * view.tilesY;
}

}  // namespace lampyris::deferred
