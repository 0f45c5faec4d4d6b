/// \file Settings: every one with its unit, its default and a sentence.
#pragma once

#include "core/display.h"
#include "photon_gi/settings.h"

namespace lampyris::overlay {

/// \param defaults  what "reset" gives back
void drawSettingsPanel(photon_gi::Settings& settings, const photon_gi::Settings& defaults,
                       core::DisplayTransform& display, bool* open);

}  // namespace lampyris::overlay
