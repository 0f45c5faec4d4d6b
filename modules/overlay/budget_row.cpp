#include "overlay/budget_row.h"

#include <fmt/format.h>

#include "overlay/words.h"

namespace lampyris::overlay {

void drawBudget(BudgetControls& controls) {
    ImGui::Checkbox("Budget", &controls.on);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "Give up paths, radius, rays and resolution to keep indirect light at it");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(120.0f);
    ImGui::DragFloat("ms of indirect light", &controls.milliseconds, 0.1f, 0.01f, 100000.0f,
                     "%.2f");
    if (!controls.on || !controls.state) return;
    const photon_gi::BudgetState& state = *controls.state;
    const std::string given = photon_gi::whatWasGivenUp(state.asked, state.given);
    text(fmt::format("{:.2f} ms, quality {:.2f}: {}", state.milliseconds, state.quality,
                     given.empty() ? "nothing was given up" : given));
    if (state.outOfReach) ImGui::TextColored(kAlarm, "out of reach: the least there is takes more");
}

}  // namespace lampyris::overlay
