/// \file What each measure gives: one figure for two pictures, and where in them it comes from.
#pragma once

#include "core/image.h"

namespace lampyris::evaluation {

struct Measure {
    double value = 0.0;
    core::Image map;  ///< one channel; each measure says what it holds
};

}  // namespace lampyris::evaluation
