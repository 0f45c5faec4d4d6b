/// \file upsample: low-resolution irradiance to full resolution, on irradiance without albedo.
///   in      surface, gathered irradiance, edge list     out   RGBA16F irradiance, W/m²
///   shader  photon_gi/upsample.comp, upsample_place.comp     theory  README [G2]
#pragma once

#include "photon_gi/gather.h"

namespace lampyris::photon_gi {

[[nodiscard]] graph::Image addUpsample(graph::Frame& frame, const deferred::Surface& surface,
                                       const Gathered& gathered, const EdgeList& edges,
                                       const GatherSettings& settings);

enum class EstimateFormat : uint8_t { Vec4, Halves };

/// \param estimates of irradiance, W/m², one a listed pixel: what stands there from now on
[[nodiscard]] graph::Image addPlaceEstimates(graph::Frame& frame, const EdgeList& edges,
                                             graph::Buffer estimates, EstimateFormat format,
                                             graph::Image irradiance);

}  // namespace lampyris::photon_gi
