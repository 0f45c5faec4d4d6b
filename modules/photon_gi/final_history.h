/// \file final history: the mean of low-resolution irradiance over frames, at each texel's place.
///   in      coarse irradiance, what the frame before left      out   the mean, frames in it
///   shader  photon_gi/final_history.comp                       theory  README [F4]
#pragma once

#include "photon_gi/final_gather.h"

namespace lampyris::photon_gi {

/// What the frame before left.
struct Past {
    bool known = false;  ///< there was one, of the same size
    bool same = false;   ///< and neither the scene nor the settings have changed since
    glm::mat4 worldToClip{1.0f};
};

/// The image that history keeps; to be asked of execute::HistoryBook.
[[nodiscard]] graph::ImageDesc historyMean(const shared::View& view, uint32_t divisor);
constexpr const char* kHistoryMean = "gather history";

/// \param frames most in the mean, this one included; 1: it begins anew; 0: as it came
[[nodiscard]] CoarseIrradiance addFinalHistory(graph::Frame& frame,
                                               const deferred::Surface& surface,
                                               const CoarseIrradiance& newest, const Past& past,
                                               uint32_t frames,
                                               const FinalGatherSettings& settings);

}  // namespace lampyris::photon_gi
