#include "overlay/shader_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "overlay/words.h"

namespace lampyris::overlay {

using shader_reload::ShaderState;
using shader_reload::ShaderStatus;

std::string brokenShaders(std::span<const ShaderStatus> shaders) {
    const auto count = std::count_if(shaders.begin(), shaders.end(), [](const ShaderStatus& s) {
        return s.state == ShaderState::Broken;
    });
    if (count == 0) return {};
    return fmt::format("{} shader{} broken", count, count == 1 ? "" : "s");
}

void drawShaderPanel(std::span<const ShaderStatus> shaders, bool* open) {
    ImGui::SetNextWindowPos({300.0f, 430.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({520.0f, 260.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Shaders", open)) {
        if (shaders.empty()) text("No folder of shaders is watched: see --shaders.");
        for (const ShaderStatus& shader : shaders) {
            if (shader.state != ShaderState::Broken) continue;
            ImGui::TextColored(kAlarm, "%s", std::string(shader.name).c_str());
            text(shader.error);
            text("What ran before goes on.");
        }
        for (const ShaderStatus& shader : shaders) {
            if (shader.state == ShaderState::Compiling)
                text(fmt::format("{}: compiling", shader.name));
            else if (shader.state == ShaderState::Waiting)
                text(fmt::format("{}: waits for what changed with it", shader.name));
            else if (shader.reloads > 0)
                text(fmt::format("{}: reloaded {} times, last in {:.0f} ms", shader.name,
                                 shader.reloads, shader.milliseconds));
        }
        if (!shaders.empty()) text(fmt::format("{} shaders are followed.", shaders.size()));
    }
    ImGui::End();
}

}  // namespace lampyris::overlay
