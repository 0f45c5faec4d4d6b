#include "overlay/feed_input.h"

#include <imgui.h>

#include <algorithm>

namespace lampyris::overlay {

static_assert(window::kKeyCount <= 512, "ImGuiIO::KeysDown");

void mapKeys(ImGuiIO& io) {
    io.KeyMap[ImGuiKey_Tab] = window::kKeyTab;
    io.KeyMap[ImGuiKey_LeftArrow] = window::kKeyLeft;
    io.KeyMap[ImGuiKey_RightArrow] = window::kKeyRight;
    io.KeyMap[ImGuiKey_UpArrow] = window::kKeyUp;
    io.KeyMap[ImGuiKey_DownArrow] = window::kKeyDown;
    io.KeyMap[ImGuiKey_PageUp] = window::kKeyPageUp;
    io.KeyMap[ImGuiKey_PageDown] = window::kKeyPageDown;
    io.KeyMap[ImGuiKey_Home] = window::kKeyHome;
    io.KeyMap[ImGuiKey_End] = window::kKeyEnd;
    io.KeyMap[ImGuiKey_Insert] = window::kKeyInsert;
    io.KeyMap[ImGuiKey_Delete] = window::kKeyDelete;
    io.KeyMap[ImGuiKey_Backspace] = window::kKeyBackspace;
    io.KeyMap[ImGuiKey_Space] = ' ';
    io.KeyMap[ImGuiKey_Enter] = window::kKeyEnter;
    io.KeyMap[ImGuiKey_KeyPadEnter] = window::kKeyKeypadEnter;
    io.KeyMap[ImGuiKey_Escape] = window::kKeyEscape;
    for (const auto& [key, letter] :
         {std::pair{ImGuiKey_A, 'A'}, std::pair{ImGuiKey_C, 'C'}, std::pair{ImGuiKey_V, 'V'},
          std::pair{ImGuiKey_X, 'X'}, std::pair{ImGuiKey_Y, 'Y'}, std::pair{ImGuiKey_Z, 'Z'}})
        io.KeyMap[key] = static_cast<unsigned char>(letter);
}

void feedInput(ImGuiIO& io, const window::Input& input, float scaleX, float scaleY) {
    // What went down and up again between two frames was down in this one.
    for (size_t key = 0; key < input.held.size(); ++key)
        io.KeysDown[key] = input.held[key] || input.pressed[key];
    io.KeyCtrl = input.control();
    io.KeyShift = input.shift();
    io.KeyAlt = input.alt();
    for (const char32_t character : input.typed) io.AddInputCharacter(character);
    io.MousePos = {static_cast<float>(input.cursorX) * scaleX,
                   static_cast<float>(input.cursorY) * scaleY};
    for (size_t button = 0; button < input.buttons.size(); ++button)
        io.MouseDown[button] = input.buttons[button] || input.clicked[button];
    io.MouseWheel = static_cast<float>(input.scrolled);
}

}  // namespace lampyris::overlay
