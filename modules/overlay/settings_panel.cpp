#include "overlay/settings_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "overlay/setting_list.h"
#include "overlay/words.h"

namespace lampyris::overlay {
namespace {

using photon_gi::Settings;

constexpr double kFirstBudget = 10.0;  // ms, where a budget is switched on

template <typename Enum, size_t N>
void editChoice(Enum& value, const std::array<const char*, N>& names) {
    int index = static_cast<int>(value);
    if (ImGui::Combo("##value", &index, names.data(), static_cast<int>(N)))
        value = static_cast<Enum>(index);
}

/// What has been typed so far into the one field that is being typed into: numbers pass through
/// others on their way, and those are not taken.
std::optional<double> typed;

template <typename T>
void take(Settings& settings, T Settings::*field, bool edited, T value) {
    if (edited && ImGui::GetIO().WantTextInput)
        typed = static_cast<double>(value);
    else if (edited)
        settings.*field = value;
    if (ImGui::IsItemDeactivatedAfterEdit() && typed)
        settings.*field = static_cast<T>(*std::exchange(typed, std::nullopt));
}

struct Editor {
    const SettingInfo& info;
    Settings& settings;

    void operator()(uint32_t Settings::*field) const {
        const auto least = static_cast<uint32_t>(info.least);
        const auto most = static_cast<uint32_t>(info.most);
        uint32_t value = settings.*field;
        const float speed = info.wide ? std::max(0.1f, 0.01f * static_cast<float>(value)) : 0.05f;
        const bool edited =
            ImGui::DragScalar("##value", ImGuiDataType_U32, &value, speed, &least, &most, "%u");
        take(settings, field, edited, std::clamp(value, least, most));
    }
    void operator()(float Settings::*field) const {
        const auto least = static_cast<float>(info.least);
        const auto most = static_cast<float>(info.most);
        float value = settings.*field;
        const bool edited = ImGui::DragFloat("##value", &value, std::max(1e-4f, 0.01f * value),
                                             least, most, "%.4g");
        take(settings, field, edited, std::clamp(value, least, most));
    }
    void operator()(bool Settings::*field) const { ImGui::Checkbox("##value", &(settings.*field)); }
    void operator()(photon_gi::Pipeline Settings::*field) const {
        editChoice(settings.*field, photon_gi::kPipelineNames);
    }
    void operator()(photon_gi::Gather Settings::*field) const {
        editChoice(settings.*field, photon_gi::kGatherNames);
    }
    void operator()(photon_gi::Retrace Settings::*field) const {
        editChoice(settings.*field, photon_gi::kRetraceNames);
    }
};

struct TextOf {
    const Settings& settings;
    std::string operator()(uint32_t Settings::*field) const {
        return fmt::format("{}", settings.*field);
    }
    std::string operator()(float Settings::*field) const {
        return fmt::format("{:g}", settings.*field);
    }
    std::string operator()(bool Settings::*field) const { return settings.*field ? "on" : "off"; }
    template <typename Enum>
    std::string operator()(Enum Settings::*field) const {
        return name(settings.*field);
    }
};

void drawRow(const SettingInfo& info, Settings& settings, const Settings& defaults) {
    ImGui::PushID(info.name);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(info.name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", info.sentence);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
    std::visit(Editor{info, settings}, info.field);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", info.sentence);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(info.unit);
    ImGui::TableNextColumn();
    const std::string now = std::visit(TextOf{settings}, info.field);
    const std::string usual = std::visit(TextOf{defaults}, info.field);
    if (now == usual)
        ImGui::TextDisabled("%s", usual.c_str());
    else if (ImGui::SmallButton(usual.c_str()))
        std::visit([&](auto field) { settings.*field = defaults.*field; }, info.field);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", info.sentence);
    ImGui::PopID();
}

void drawBudget(std::optional<double>& milliseconds,
                const std::optional<photon_gi::BudgetState>& state) {
    bool on = milliseconds.has_value();
    if (ImGui::Checkbox("keep indirect light at", &on))
        milliseconds = on ? std::optional{kFirstBudget} : std::nullopt;
    if (!milliseconds) return;
    auto wanted = static_cast<float>(*milliseconds);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(90.0f);
    if (ImGui::DragFloat("ms", &wanted, std::max(0.01f, 0.01f * wanted), 0.01f, 1e5f, "%.2f"))
        milliseconds = std::max(0.01, static_cast<double>(wanted));
    if (!state) return;
    text(fmt::format("takes {:.2f} ms{}", state->milliseconds,
                     state->outOfReach ? ": the least there is costs more" : ""));
    const std::string up = photon_gi::whatWasGivenUp(state->asked, state->given);
    text(up.empty() ? "nothing is given up" : "given up: " + up);
}

}  // namespace

void drawSettingsPanel(Settings& settings, const Settings& defaults,
                       core::DisplayTransform& display, const BudgetChoice& budget, bool* open) {
    ImGui::SetNextWindowPos({400.0f, 240.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({560.0f, 480.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Settings", open)) {
        ImGui::SetNextItemWidth(160.0f);
        ImGui::SliderFloat("exposure, EV", &display.exposureEv, -10.0f, 10.0f, "%.2f",
                           ImGuiSliderFlags_AlwaysClamp);
        int tonemap = static_cast<int>(display.tonemap);
        ImGui::SetNextItemWidth(160.0f);
        if (ImGui::Combo("tone map", &tonemap, core::kTonemapNames.data(),
                         static_cast<int>(core::kTonemapNames.size())))
            display.tonemap = static_cast<core::Tonemap>(tonemap);
        if (budget.milliseconds != nullptr) drawBudget(*budget.milliseconds, budget.state);
        const auto flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable;
        if (ImGui::BeginTable("settings", 5, flags)) {
            ImGui::TableSetupColumn("setting", ImGuiTableColumnFlags_WidthStretch, 1.1f);
            ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1.0f);
            ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthStretch, 0.6f);
            ImGui::TableSetupColumn("default", ImGuiTableColumnFlags_WidthStretch, 0.7f);
            ImGui::TableSetupColumn("what it does", ImGuiTableColumnFlags_WidthStretch, 3.2f);
            ImGui::TableHeadersRow();
            for (const SettingInfo& info : settingList()) drawRow(info, settings, defaults);
            ImGui::EndTable();
        }
        photon_gi::mend(settings);
    }
    ImGui::End();
}

}  // namespace lampyris::overlay
