/// \file `view --budget-ms`: settings that follow what frames take.
#pragma once

#include <optional>
#include <string>

#include "frame_loop.h"
#include "photon_gi/budget.h"

namespace lampyris::sandbox {

/// Whether there is something that a budget could give up: a wrong call where there is not.
core::Result<void> checkBudget(const Options& options, std::optional<double> milliseconds);

class LiveBudget {
 public:
    /// \param asked what is drawn where no budget says otherwise
    LiveBudget(const photon_gi::Settings& asked, std::optional<double> milliseconds);

    /// None: all that was asked for, whatever it takes.
    void setMilliseconds(std::optional<double> milliseconds);
    photon_gi::Settings asked;  ///< may change at any time

    /// Before a frame: chooses its settings.
    void choose(FrameLoop& loop);
    /// After it.
    void learn(const LoopFrame& frame);

    [[nodiscard]] std::optional<photon_gi::BudgetState> state() const;
    /// For a window's title: ", indirect light 11.8 of 12.0 ms, paths 900 instead of 2500"; empty
    /// without a budget.
    [[nodiscard]] std::string text() const;

 private:
    std::optional<photon_gi::Budget> budget_;
};

}  // namespace lampyris::sandbox
