/// \file Controls of a running scene, in the menu bar: time, camera, handles, what comes and goes.
#pragma once

#include <string>

#include "overlay/handles.h"

namespace lampyris::overlay {

/// What the game does, and what the user asks for; the game clears the wishes it has met.
struct PlayControls {
    bool paused = false;
    float timeScale = 1.0f;
    bool walks = false;  ///< the camera stands on the ground; otherwise it flies
    HandleKind handles = HandleKind::Move;

    bool step = false;  ///< wish: one frame while paused
    bool spawnLight = false, spawnBox = false, deleteSelected = false;  ///< wishes
    bool screenshot = false;                                            ///< wish
    std::string message;  ///< the last thing done, for the user to read
};

/// Between ImGui::BeginMainMenuBar() and its end.
void drawPlayBar(PlayControls& controls);

}  // namespace lampyris::overlay
