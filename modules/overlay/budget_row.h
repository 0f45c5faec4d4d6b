/// \file A budget of milliseconds, over the settings: what is wanted, and what was given up for it.
#pragma once

#include <optional>

#include "photon_gi/budget.h"

namespace lampyris::overlay {

struct BudgetControls {
    bool on = false;
    float milliseconds = 16.7f;                     ///< of indirect light, on the device
    std::optional<photon_gi::BudgetState> state{};  ///< while it is on
};

/// A line or two of the panel that is being drawn.
void drawBudget(BudgetControls& controls);

}  // namespace lampyris::overlay
