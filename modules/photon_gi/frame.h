/// \file The frame, from the scene to the finished picture. frame.cpp is the file to read first.
#pragma once

#include <vector>

#include "accel/accel_on_gpu.h"
#include "graph/frame.h"
#include "photon_gi/final_history.h"
#include "photon_gi/settings.h"
#include "photons/path_store.h"
#include "residency/scene_handles.h"
#include "shared/view.h"

namespace lampyris::photon_gi {

/// All that a frame is drawn from.
struct FrameInputs {
    residency::SceneHandles scene;
    accel::AccelHandles accel;
    std::vector<residency::DrawItem> draws;
    photons::PathSplit paths;
    bool pathsKept = false;             ///< they go through the store
    photons::PathStoreHandles store{};  ///< where they do
    photons::PathChoice choice;         ///< of them, to be traced
    shared::View view{};
    uint32_t seed = 1;      ///< of this frame
    uint32_t turn = 0;      ///< its number; 0 where every frame draws the same numbers
    uint32_t pathTurn = 0;  ///< of the paths that it draws anew
    Past past;
    bool settles = false;  ///< its picture is kept, see recallFinal()
};

/// For onlookers, who may draw over the picture what the frame is made of. Handles are invalid
/// where it has no such thing.
struct Insides {
    shared::View view{};
    graph::Image depth{};           ///< D32, reversed
    photons::PhotonList photons{};  ///< of the last batch
    graph::Buffer tileRanges{};     ///< of the last batch; uvec2 a tile: first index, count
    graph::Image mean{};            ///< low resolution, a = frames in the mean of light
    uint32_t meanDivisor = 1;       ///< pixels a texel of it, an axis
    accel::AccelHandles accel{};
};

/// What came of it. The buffers are for reading back after the frame.
struct DrawnFrame {
    graph::Image radiance{};   ///< "final": RGBA16F
    graph::Buffer counters{};  ///< shared::FrameCounters; invalid where there is no indirect light
    std::vector<graph::Buffer> ledgers;  ///< a batch each
    graph::Buffer lightReach{};  ///< metres a light, then the watts cut off; invalid where settled
    graph::Buffer importance{};  ///< a float a path, for PathGuide; invalid where none is guided
    Insides insides{};
};

[[nodiscard]] DrawnFrame drawFrame(graph::Frame& frame, const FrameInputs& in,
                                   const Settings& settings, const Capacities& room);

}  // namespace lampyris::photon_gi
