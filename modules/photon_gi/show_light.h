/// \file show: the parts of the light as images to look at. Published under direct, indirect,
/// irradiance_direct, irradiance_indirect and edges; the graph culls those that nobody asks for.
#pragma once

#include "deferred/sphere_direct.h"
#include "photon_gi/gather.h"

namespace lampyris::photon_gi {

/// \param indirect, edges invalid where the pipeline has none: then those images are black
void publishLight(graph::Frame& frame, const deferred::Surface& surface,
                  const deferred::DirectLight& direct, graph::Image indirect,
                  const EdgeList& edges);

}  // namespace lampyris::photon_gi
