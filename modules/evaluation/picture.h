/// \file A picture as the measures need it: what a screen shows of it, and its linear light.
#pragma once

#include <string>

#include "core/display.h"
#include "core/image.h"
#include "core/result.h"

namespace lampyris::evaluation {

struct Picture {
    std::string name;            ///< as errors call it
    core::DisplayImage display;  ///< what all measures but relMSE compare
    core::Image linear;          ///< three channels, finite
};

/// From linear radiance of 1, 3 or 4 channels (one is spread, the fourth dropped); `transform`
/// gives the display values alone. NaN or infinity is an error that names the picture, pixel and
/// channel.
core::Result<Picture> fromLinear(std::string name, const core::Image& image,
                                 const core::DisplayTransform& transform);

/// From display values; linear light is what they stand for, from 0 to 1.
Picture fromDisplay(std::string name, core::DisplayImage display);

/// An error that names both where they differ in size, or have no pixels.
core::Result<void> checkComparable(const Picture& image, const Picture& reference);

}  // namespace lampyris::evaluation
