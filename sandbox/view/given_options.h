/// \file What a call's options say against a settings file.
#pragma once

#include "view/settings_file.h"
#include "view/view_options.h"

namespace lampyris::sandbox::view {

/// Options that were given stand against what a file says, and so does what follows from them.
void overrideBy(const ViewOptions& options, ViewState& state);

}  // namespace lampyris::sandbox::view
