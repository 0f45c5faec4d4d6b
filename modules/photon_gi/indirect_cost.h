/// \file What of a frame's time is indirect light's: that of the nodes that trace photons, sort
/// them and gather their light. Surfaces, direct light, the composite, what keeps the scene up to
/// date, and all that a program adds of its own are none of it.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "execute/statistics.h"

namespace lampyris::photon_gi {

/// The nodes of indirect light, as reports name them (execute::reportedName).
constexpr std::array<std::string_view, 5> kIndirect{"photon_trace", "irradiance_grid", "tile_bin",
                                                    "gather", "upsample"};

[[nodiscard]] bool isIndirect(const std::string& nodeName);

/// Device milliseconds by what they follow; or, in a budget, factors to such milliseconds.
struct IndirectCost {
    double photons = 0.0;   ///< paths, and the grid or tiles: all indirect nodes but the next two
    double gather = 0.0;    ///< rays of the texels
    double upsample = 0.0;  ///< pixels, and the rays of those that stand alone

    [[nodiscard]] double sum() const { return photons + gather + upsample; }
    [[nodiscard]] IndirectCost times(const IndirectCost& f) const {
        return {photons * f.photons, gather * f.gather, upsample * f.upsample};
    }
    [[nodiscard]] IndirectCost times(double f) const { return times({f, f, f}); }
};

/// Zeros where the frame drew no indirect light, as one that is shown again does.
[[nodiscard]] IndirectCost indirectCost(const execute::FrameStatistics& frame);

}  // namespace lampyris::photon_gi
