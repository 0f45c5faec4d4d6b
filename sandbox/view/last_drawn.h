/// \file The settings that a frame last came out with, and the way back to them.
#pragma once

#include <optional>

#include "photon_gi/settings.h"

namespace lampyris::sandbox::view {

class LastDrawn {
 public:
    /// A frame came out: with what was asked for, and with what a budget made of that.
    void drew(const photon_gi::Settings& asked, const photon_gi::Settings& given);
    /// What was asked for then; nothing before the first.
    [[nodiscard]] const std::optional<photon_gi::Settings>& asked() const { return asked_; }

    /// What to ask for after a frame failed: what was asked for when one came out, and where that
    /// is what failed, what was given then. Nothing where no other settings are left.
    std::optional<photon_gi::Settings> insteadOf(const photon_gi::Settings& asked,
                                                 const photon_gi::Settings& given);

 private:
    std::optional<photon_gi::Settings> asked_, given_;
};

}  // namespace lampyris::sandbox::view
