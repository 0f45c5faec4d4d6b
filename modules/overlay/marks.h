/// \file overlay/photons, /paths, /boxes, /heat: what the frame is made of, over the picture.
///   in      photon_gi::Insides, the picture as 8-bit display values      out   the picture
///   shader  overlay/photons.vert, paths.vert, boxes.vert, mark.frag, heat.comp
#pragma once

#include <algorithm>

#include "photon_gi/frame.h"

namespace lampyris::overlay {

enum class Colouring : uint8_t { Power, Bounce };
enum class Heat : uint8_t {
    None,
    Tiles,    ///< photons a tile, where the gather is from tiles
    History,  ///< frames in the mean of light, at low resolution
};

/// What is drawn over the picture.
struct MarkChoice {
    bool photons = false;
    bool paths = false;
    bool throughWalls = false;  ///< what surfaces hide is drawn too
    Colouring colouring = Colouring::Power;
    float brightnessEv = 0.0f;  ///< of colours by power, doubling
    float radiusPixels = 1.5f;  ///< of a photon
    bool boxes = false;         ///< of the BVH
    uint32_t boxLevel = 4;      ///< below the root
    uint32_t most = 1u << 18;   ///< [chosen] photons, and paths: more would hide the picture
    Heat heat = Heat::None;
    float heatMost = photon_gi::Settings{}.history;  ///< shown as white: of frames, a full mean
    float heatOpacity = 0.7f;

    [[nodiscard]] bool any() const { return photons || paths || boxes || heat != Heat::None; }
};

/// Whether frames of these settings have what the heat shows.
[[nodiscard]] bool hasHeat(Heat heat, const photon_gi::Settings& settings);

constexpr uint32_t kLeastBoxLevel = 1;  ///< the root has children, and no box of its own
constexpr uint32_t kMostBoxLevel = 12;

/// Where a frame has more photons or paths than are drawn, each so manieth is.
[[nodiscard]] inline uint32_t markStride(uint32_t photons, uint32_t paths, uint32_t most) {
    return std::max(1u, (std::max(photons, paths) + most - 1) / most);
}

/// Leaves out what the frame has not.
[[nodiscard]] graph::Image addMarks(graph::Frame& frame, const photon_gi::Insides& insides,
                                    const MarkChoice& choice, graph::Image shown);

}  // namespace lampyris::overlay
