/// \file Settings: every one with its unit, its default and a sentence.
#pragma once

#include "core/display.h"
#include "overlay/budget_row.h"
#include "photon_gi/settings.h"

namespace lampyris::overlay {

/// \param defaults  what "reset" gives back
/// \param budget  shown above them; null: none
void drawSettingsPanel(photon_gi::Settings& settings, const photon_gi::Settings& defaults,
                       core::DisplayTransform& display, bool* open,
                       BudgetControls* budget = nullptr);

}  // namespace lampyris::overlay
