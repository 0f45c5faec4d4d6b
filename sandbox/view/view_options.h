/// \file What `lampyris view` takes besides the options of every frame.
#pragma once

#include "options.h"

namespace lampyris::sandbox {

struct ViewOptions : Options {
    std::filesystem::path flicker;      ///< --flicker
    std::filesystem::path settings;     ///< --settings: read at the start, written at the end
    std::filesystem::path record;       ///< --record: inputs
    std::filesystem::path replay;       ///< --replay
    std::filesystem::path screenshots;  ///< --screenshots: a folder
    bool overlay = true;
};

}  // namespace lampyris::sandbox
