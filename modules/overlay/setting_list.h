/// \file Every setting of photon_gi with its unit, range and a sentence. No ImGui.
#pragma once

#include <span>
#include <variant>

#include "photon_gi/settings.h"

namespace lampyris::overlay {

struct SettingInfo {
    using Settings = photon_gi::Settings;
    using Field = std::variant<uint32_t Settings::*, float Settings::*, bool Settings::*,
                               photon_gi::Pipeline Settings::*, photon_gi::Gather Settings::*,
                               photon_gi::Retrace Settings::*>;
    const char* name;
    const char* unit;  ///< empty: a number
    Field field;
    double least = 0.0, most = 0.0;  ///< of numbers
    bool wide = false;               ///< moves by factors rather than steps
    const char* sentence;
};

/// In the order of photon_gi::Settings.
[[nodiscard]] std::span<const SettingInfo> settingList();

}  // namespace lampyris::overlay
