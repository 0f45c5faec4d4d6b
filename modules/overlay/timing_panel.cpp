#include "overlay/timing_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/file.h"
#include "execute/chrome_trace.h"
#include "overlay/words.h"

namespace lampyris::overlay {
namespace {

constexpr float kHistoryHeight = 90.0f;
const ImVec4 kOver{0.95f, 0.35f, 0.25f, 1.0f};
const ImVec4 kUnder{0.45f, 0.75f, 0.45f, 1.0f};

/// A value's share of `whole`, behind the number.
void bar(float value, float whole) {
    const std::string label = fmt::format("{:.3f}", value);
    ImGui::ProgressBar(whole > 0.0f ? value / whole : 0.0f, {-1.0f, 0.0f}, label.c_str());
}

}  // namespace

void TimingPanel::clear() {
    times_.clear();
    overlayCpu_.clear();
}

void TimingPanel::add(const execute::FrameStatistics& frame, double overlayMilliseconds,
                      const TimedWith& with) {
    if (frozen_) return;
    if (with_ != with) clear();
    with_ = with;
    times_.add(frame);
    overlayCpu_.push_back(static_cast<float>(overlayMilliseconds));
    if (overlayCpu_.size() > NodeTimes::kFrames) overlayCpu_.erase(overlayCpu_.begin());
}

float TimingPanel::overlayMilliseconds() const {
    if (overlayCpu_.empty()) return 0.0f;
    std::vector<float> sorted = overlayCpu_;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
}

void TimingPanel::draw(bool* open) {
    ImGui::SetNextWindowPos({10.0f, 30.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({430.0f, 520.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("GPU timing", open)) {
        drawButtons();
        drawFrame();
        drawHistory();
        drawNodes();
    }
    ImGui::End();
}

void TimingPanel::drawButtons() {
    ImGui::Checkbox("Freeze", &frozen_);
    ImGui::SameLine();
    bool apart = times_.partsApart();
    if (ImGui::Checkbox("Parts", &apart)) times_.setPartsApart(apart);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Each part of a node as a row of its own");
    ImGui::SameLine();
    if (ImGui::Button("Clear")) clear();
    ImGui::SameLine();
    if (ImGui::Button("Copy CSV")) ImGui::SetClipboardText(times_.csv().c_str());
    ImGui::SameLine();
    if (ImGui::Button("Chrome trace")) {
        execute::ChromeTrace trace;
        for (const auto& frame : times_.frames()) trace.add(frame);
        const auto written = core::writeFile(traceFile, trace.text());
        written_ = written.ok() ? "written: " + traceFile.string() : written.error().message;
    }
    if (!written_.empty()) text(written_);
}

void TimingPanel::drawFrame() {
    const NodeRow& whole = times_.whole();
    const float last = whole.gpu.empty() ? 0.0f : whole.gpu.back();
    ImGui::PushStyleColor(ImGuiCol_Text, last > budgetMilliseconds ? kOver : kUnder);
    text(fmt::format("device {:.2f} ms, median {:.2f} ms, p95 {:.2f} ms", last, whole.gpuMedian,
                     whole.gpuP95));
    ImGui::PopStyleColor();
    text(fmt::format("CPU, medians: recording {:.2f} ms, overlay {:.2f} ms", whole.cpuMedian,
                     overlayMilliseconds()));
    ImGui::SetNextItemWidth(120.0f);
    ImGui::DragFloat("budget, ms", &budgetMilliseconds, 0.1f, 0.1f, 10000.0f, "%.1f");
}

void TimingPanel::drawHistory() {
    const NodeRow* row = &times_.whole();
    for (const NodeRow& node : times_.rows())
        if (node.name == selected_) row = &node;
    if (row->gpu.empty()) return;
    const bool isFrame = row == &times_.whole();
    float most = *std::max_element(row->gpu.begin(), row->gpu.end());
    if (isFrame) most = std::max(most, budgetMilliseconds);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = remainingWidth();
    const std::string label = fmt::format("{}: {:.2f} ms", row->name, row->gpu.back());
    ImGui::PlotLines("##history", row->gpu.data(), static_cast<int>(row->gpu.size()), 0,
                     label.c_str(), 0.0f, 1.1f * most, {width, kHistoryHeight});
    if (!isFrame || most <= 0.0f) return;
    const ImVec2 padding = ImGui::GetStyle().FramePadding;  // the plot lies within it
    const float inside = kHistoryHeight - 2.0f * padding.y;
    const float y = corner.y + padding.y + inside * (1.0f - budgetMilliseconds / (1.1f * most));
    ImGui::GetWindowDrawList()->AddLine(
        {corner.x + padding.x, y}, {corner.x + width - padding.x, y}, ImGui::GetColorU32(kOver));
}

void TimingPanel::drawNodes() {
    const auto flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_Resizable;
    if (!ImGui::BeginTable("nodes", 5, flags)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("node", ImGuiTableColumnFlags_WidthStretch, 1.4f);
    for (const char* name : {"last, ms", "median, ms", "p95, ms", "record, ms"})
        ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthStretch, 1.1f);
    ImGui::TableHeadersRow();
    const float whole = times_.whole().gpu.empty() ? 0.0f : times_.whole().gpu.back();
    for (const NodeRow& row : times_.rows()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        const bool chosen = row.name == selected_;
        if (ImGui::Selectable(row.name.c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns))
            selected_ = chosen ? std::string{} : row.name;
        ImGui::TableNextColumn();
        bar(row.gpu.back(), whole);
        for (const float value : {row.gpuMedian, row.gpuP95, row.cpuMedian}) {
            ImGui::TableNextColumn();
            ImGui::Text("%.3f", static_cast<double>(value));
        }
    }
    ImGui::EndTable();
}

}  // namespace lampyris::overlay
