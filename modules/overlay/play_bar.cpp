#include "overlay/play_bar.h"

#include <imgui.h>

namespace lampyris::overlay {
namespace {

void drawHandleKind(HandleKind& kind, HandleKind choice, const char* name, const char* key) {
    if (ImGui::MenuItem(name, key, kind == choice)) kind = choice;
}

}  // namespace

void drawPlayBar(PlayControls& c) {
    if (ImGui::BeginMenu("Play")) {
        ImGui::MenuItem("Pause", "Space", &c.paused);
        if (ImGui::MenuItem("Single step", ".", false, c.paused)) c.step = true;
        ImGui::SetNextItemWidth(120.0f);
        ImGui::SliderFloat("time scale", &c.timeScale, -4.0f, 4.0f, "%.2f",
                           ImGuiSliderFlags_AlwaysClamp);
        ImGui::SetNextItemWidth(120.0f);
        ImGui::SliderFloat("render scale", &c.renderScale, 0.1f, 1.0f, "%.2f",
                           ImGuiSliderFlags_AlwaysClamp);
        ImGui::MenuItem("Walk", "C", &c.walks);
        if (ImGui::MenuItem("Screenshot", "F12")) c.screenshot = true;
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Edit")) {
        drawHandleKind(c.handles, HandleKind::Move, "Move", "1");
        drawHandleKind(c.handles, HandleKind::Rotate, "Rotate", "2");
        drawHandleKind(c.handles, HandleKind::Scale, "Scale", "3");
        ImGui::Separator();
        if (ImGui::MenuItem("New light", "L")) c.spawnLight = true;
        if (ImGui::MenuItem("New box", "B")) c.spawnBox = true;
        if (ImGui::MenuItem("Delete selected", "Delete")) c.deleteSelected = true;
        ImGui::EndMenu();
    }
    ImGui::TextUnformatted(c.paused ? "  paused" : "");
    if (!c.message.empty()) ImGui::TextDisabled("  %s", c.message.c_str());
}

}  // namespace lampyris::overlay
