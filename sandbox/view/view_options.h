/// \file What `lampyris view` takes besides the options of every frame.
#pragma once

#include <set>
#include <string>

#include "options.h"

namespace lampyris::sandbox {

struct ViewOptions : Options {
    std::filesystem::path flicker;      ///< --flicker
    std::filesystem::path settings;     ///< --settings: read at the start, written at the end
    std::filesystem::path record;       ///< --record: inputs
    std::filesystem::path replay;       ///< --replay
    std::filesystem::path screenshots;  ///< --screenshots: a folder
    std::string shaders;                ///< --shaders: a folder, or off
    std::set<std::string> given;        ///< names of the options that the call has, with dashes
    bool overlay = true;
    std::optional<double> budgetMilliseconds;  ///< --budget-ms: of indirect light, on the device
    std::optional<float> renderScale;  ///< --render-scale: picture pixels a window pixel, an axis
};

}  // namespace lampyris::sandbox
