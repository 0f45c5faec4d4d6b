/// \file final history: the mean of low-resolution irradiance over frames, at each texel's place.
///   in      coarse irradiance, what the frame before left      out   the mean, frames in it
///   shader  photon_gi/final_history.comp                       theory  README [F4], [H1], [H2]
#pragma once

#include "photon_gi/final_gather.h"
#include "scene/changes.h"

namespace lampyris::photon_gi {

/// What the frame before left.
struct Past {
    bool known = false;  ///< there was one, of the same size
    bool same = false;   ///< and its light was all there, made with the same settings
    glm::mat4 worldToClip{1.0f};
    scene::SceneChanges changes;  ///< since that frame
    /// A change has not left the mean of frames yet.
    bool doubted = false;
    std::vector<scene::SnapshotLight> lights;  ///< of this frame
    bool still = false;  ///< nothing changed, the view neither: surface and direct light are kept
};

/// The image that history keeps; to be asked of execute::HistoryBook.
[[nodiscard]] graph::ImageDesc historyMean(const shared::View& view, uint32_t divisor);
constexpr const char* kHistoryMean = "gather history";

/// \param motion from pixels to where their surface was in the frame before, metres; or invalid
/// \param frames most in the mean, this one included; 1: it begins anew; 0: as it came
[[nodiscard]] CoarseIrradiance addFinalHistory(graph::Frame& frame,
                                               const deferred::Surface& surface,
                                               const CoarseIrradiance& newest, graph::Image motion,
                                               const Past& past, uint32_t frames,
                                               const FinalGatherSettings& settings);

}  // namespace lampyris::photon_gi
