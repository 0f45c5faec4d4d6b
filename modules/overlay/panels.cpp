#include "overlay/panels.h"
#include "overlay/words.h"

#include <fmt/format.h>
#include <imgui.h>

namespace lampyris::overlay {

core::Result<Panels> Panels::create(gpu::Device& device, const ecs::Registry& registry) {
    TRY(ImageLook look, ImageLook::create(device));
    TRY(TruthPanel truth, TruthPanel::create(device));
    return Panels{std::move(look), std::move(truth), registry};
}

void Panels::drawMenu(const FrameSeen& seen, std::span<const shader_reload::ShaderStatus> shaders,
                      PlayControls* play) {
    if (!ImGui::BeginMainMenuBar()) return;
    if (ImGui::BeginMenu("Panels")) {
        ImGui::MenuItem("GPU timing", nullptr, &open.timing);
        ImGui::MenuItem("Graph", nullptr, &open.graph);
        ImGui::MenuItem("Photons", nullptr, &open.light);
        ImGui::MenuItem("Truth", nullptr, &open.truth);
        ImGui::MenuItem("Scene", nullptr, &open.scene);
        ImGui::MenuItem("Settings", nullptr, &open.settings);
        ImGui::MenuItem("Shaders", nullptr, &open.shaders);
        ImGui::EndMenu();
    }
    if (play != nullptr) drawPlayBar(*play);
    ImGui::Text("  %.2f ms", seen.statistics.gpuMilliseconds);
    if (!seen.report.valid) ImGui::TextColored(kAlarm, "INVALID FRAME");
    const std::string broken = brokenShaders(shaders);
    if (!broken.empty()) ImGui::TextColored(kAlarm, "  %s", broken.c_str());
    ImGui::EndMainMenuBar();
}

void Panels::draw(const FrameSeen& seen, const photons::PathSplit& paths, const Editable& edits,
                  std::span<const shader_reload::ShaderStatus> shaders, PlayControls* play) {
    drawMenu(seen, shaders, play);
    if (open.timing) timing.draw(&open.timing);
    if (open.graph) graph_.draw(seen, look.choice, &open.graph);
    if (open.light) drawLightPanel(seen, paths, edits.settings, marks, &open.light);
    if (open.truth)
        truth.draw(seen, look.choice, &open.truth);
    else
        truth.switchOff();
    if (open.scene) scene_.draw(edits.world, edits.selected, &open.scene);
    if (open.settings)
        drawSettingsPanel(edits.settings, edits.defaults, edits.display,
                          {edits.budgetMilliseconds, edits.budget}, &open.settings);
    // What the next frame has not is no reason to draw it whole.
    if (!hasHeat(marks.heat, edits.settings)) marks.heat = Heat::None;
    if (open.shaders) drawShaderPanel(shaders, &open.shaders);
    drawImagePanel(look);
}

}  // namespace lampyris::overlay
