/// \file What of a frame's time is indirect light's, as DESIGN.md has it: all nodes but those of
/// surfaces, direct light, the composite, and what keeps the scene up to date.
#pragma once

#include <array>
#include <string_view>

#include "execute/statistics.h"

namespace lampyris::photon_gi {

/// How the names of nodes begin that are no indirect light's.
constexpr std::array<std::string_view, 11> kNotIndirect{
    "gbuffer", "sphere_direct", "composite", "other",  "shadow", "refit",
    "tlas",    "skin",          "morph",     "upload", "overlay"};

[[nodiscard]] bool isIndirect(std::string_view nodeName);

/// Device milliseconds by what they follow; or, in a budget, factors to such milliseconds.
struct IndirectCost {
    double photons = 0.0;   ///< paths and the grid: all indirect nodes but the next two
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
