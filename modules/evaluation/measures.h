/// \file All measures by name, in the order in which they are printed.
#pragma once

#include <span>

#include "core/result.h"
#include "evaluation/measure.h"
#include "evaluation/picture.h"

namespace lampyris::evaluation {

struct NamedMeasure {
    const char* name;
    core::Result<Measure> (*measure)(const Picture& image, const Picture& reference);
};

/// MSE, NRMSE, MSSIM, FLIP, relMSE.
[[nodiscard]] std::span<const NamedMeasure> allMeasures();

}  // namespace lampyris::evaluation
