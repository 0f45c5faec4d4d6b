/// \file Words in a panel.
#pragma once

#include <imgui.h>

#include <string>

namespace lampyris::overlay {

const ImVec4 kAlarm{1.0f, 0.3f, 0.25f, 1.0f};  ///< colour of what must not be overlooked

/// Broken into lines where the panel ends.
inline void text(const std::string& words) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
    ImGui::PopTextWrapPos();
}

/// From here to the panel's right border: plots take no "all there is".
inline float remainingWidth() {
    return ImGui::GetContentRegionAvail().x;
}

}  // namespace lampyris::overlay
