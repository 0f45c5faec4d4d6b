/// \file Where two pictures differ in edges and points, as an eye sees them.
#pragma once

#include "evaluation/plane.h"

namespace lampyris::evaluation {

/// Difference in features a pixel, 0 to 1, from luminances of 0 to 1, README [E4c].
[[nodiscard]] Plane featureDifference(const Plane& luminanceA, const Plane& luminanceB,
                                      double pixelsPerDegree);

}  // namespace lampyris::evaluation
