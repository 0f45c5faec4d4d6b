/// \file tile_bin of `thesis`: every tile tests every photon, once to count and once to insert.
///   in      photons, tile bounds          out   as tile_bin.h, the same lists
///   shader  photon_gi/tile_test.comp      theory  Thesis 5.3.3.1
#pragma once

#include "photon_gi/tile_bin.h"

namespace lampyris::photon_gi {

[[nodiscard]] TileBins addTileTest(graph::Frame& frame, const photons::PhotonList& photons,
                                   const deferred::TileBounds& bounds, const shared::View& view,
                                   const TileSettings& settings);

}  // namespace lampyris::photon_gi
