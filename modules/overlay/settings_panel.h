/// \file Settings: every one with its unit, its default and a sentence.
#pragma once

#include "core/display.h"
#include "photon_gi/budget.h"

namespace lampyris::overlay {

/// Milliseconds of indirect light instead of knobs.
struct BudgetChoice {
    std::optional<double>* milliseconds = nullptr;  ///< null: none is offered
    std::optional<photon_gi::BudgetState> state{};  ///< of the one that is kept
};

/// \param defaults  what "reset" gives back
void drawSettingsPanel(photon_gi::Settings& settings, const photon_gi::Settings& defaults,
                       core::DisplayTransform& display, const BudgetChoice& budget, bool* open);

}  // namespace lampyris::overlay
