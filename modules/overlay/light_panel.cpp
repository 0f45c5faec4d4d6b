#include "overlay/light_panel.h"
#include "overlay/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace lampyris::overlay {
namespace {

constexpr float kSquare = 110.0f;  // pixels: an emitter's ways out

void drawMarks(MarkChoice& choice) {
    ImGui::Checkbox("photons", &choice.photons);
    ImGui::SameLine();
    ImGui::Checkbox("paths", &choice.paths);
    ImGui::SameLine();
    ImGui::Checkbox("BVH boxes", &choice.boxes);
    ImGui::SameLine();
    ImGui::Checkbox("through walls", &choice.throughWalls);
    int colouring = static_cast<int>(choice.colouring);
    ImGui::RadioButton("by power", &colouring, static_cast<int>(Colouring::Power));
    ImGui::SameLine();
    ImGui::RadioButton("by bounce", &colouring, static_cast<int>(Colouring::Bounce));
    choice.colouring = static_cast<Colouring>(colouring);
    ImGui::SetNextItemWidth(160.0f);
    ImGui::SliderFloat("brightness, EV", &choice.brightnessEv, -8.0f, 8.0f, "%.1f");
    ImGui::SetNextItemWidth(160.0f);
    ImGui::SliderFloat("photon, pixels", &choice.radiusPixels, 0.5f, 8.0f, "%.1f");
    int level = static_cast<int>(choice.boxLevel);
    ImGui::SetNextItemWidth(160.0f);
    ImGui::SliderInt("BVH level", &level, static_cast<int>(kLeastBoxLevel),
                     static_cast<int>(kMostBoxLevel), "%d", ImGuiSliderFlags_AlwaysClamp);
    choice.boxLevel = static_cast<uint32_t>(level);
}

/// Says so where not all is drawn that there is.
void drawStride(const FrameSeen& seen, const MarkChoice& choice) {
    const shared::FrameCounters& c = seen.report.counters;
    // Of several batches the last is drawn; they are of a size.
    const double share = c.photonsNeeded / std::max(1.0, static_cast<double>(c.photonsStored));
    const auto paths = static_cast<uint32_t>(seen.report.paths * std::min(share, 1.0));
    const uint32_t stride = markStride(c.photonsNeeded, paths, choice.most);
    if ((choice.photons || choice.paths) && stride > 1)
        text(fmt::format("one in {} is drawn", stride));
}

void drawHeat(const photon_gi::Settings& settings, MarkChoice& choice) {
    const auto offer = [&](const char* label, Heat heat) {
        ImGui::SameLine();
        ImGui::BeginDisabled(!hasHeat(heat, settings));
        if (ImGui::RadioButton(label, choice.heat == heat)) choice.heat = heat;
        ImGui::EndDisabled();
    };
    text("heat:");
    offer("none", Heat::None);
    offer("photons a tile", Heat::Tiles);
    offer("frames in the mean", Heat::History);
    if (!hasHeat(Heat::Tiles, settings) && !hasHeat(Heat::History, settings))
        text("Direct light has neither tiles nor a mean.");
    else if (!hasHeat(Heat::Tiles, settings))
        text("Tiles have photons where the gather is tiles.");
    else
        text("There is a mean where the gather is final.");
    ImGui::SetNextItemWidth(160.0f);
    ImGui::SliderFloat("shown as white", &choice.heatMost, 1.0f, 4096.0f, "%.0f",
                       ImGuiSliderFlags_Logarithmic);
}

void drawCounts(const FrameSeen& seen) {
    const photon_gi::FrameReport& report = seen.report;
    const shared::FrameCounters& c = report.counters;
    text(fmt::format("paths {}, traced again {}, photons {}", report.paths, report.retraced,
                     c.photonsStored));
    text(fmt::format("grid cells {}, tile entries {}, most in a tile {}", c.cells, c.pairs,
                     c.mostInTile));
    text(fmt::format("pixels recomputed at edges {} ({:.1f} %)", c.pixelsRecomputed,
                     100.0 * c.pixelsRecomputed / std::max(1.0, seen.pixels())));
    const accel::AccelCounts& accel = seen.accel;
    text(fmt::format("BVH: {} triangles in {} trees, {} instances", accel.triangles, accel.blas,
                     seen.snapshot.instances.size()));
    text(fmt::format("this frame {} refits ({:.2f} ms on the CPU), {} rebuilds; SAH ratio {:.2f}",
                     accel.refits, accel.refitMilliseconds, accel.rebuilds, accel.sahRatioMax));
}

/// The parts of one emitter's ways out: brighter ones send more paths a watt.
void drawEmitter(const std::vector<shared::PathRange>& ranges, size_t first, size_t end) {
    float most = 0.0f;
    const auto density = [&](const shared::PathRange& r) {
        return static_cast<float>(r.pathCount) / std::max(r.part.z * r.part.w, 1e-6f);
    };
    for (size_t i = first; i < end; ++i) most = std::max(most, density(ranges[i]));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({kSquare, kSquare});
    for (size_t i = first; i < end; ++i) {
        const shared::PathRange& r = ranges[i];
        const ImVec2 from{corner.x + kSquare * r.part.x, corner.y + kSquare * r.part.y};
        const ImVec2 to{from.x + kSquare * r.part.z, from.y + kSquare * r.part.w};
        const float x = most > 0.0f ? density(r) / most : 0.0f;
        ImGui::GetWindowDrawList()->AddRectFilled(from, to, ImColor(x, 0.75f * x, 0.3f * x + 0.1f));
        if (ImGui::IsMouseHoveringRect(from, to))
            ImGui::SetTooltip("%u paths of %.3g W", r.pathCount,
                              static_cast<double>(r.powerPerPath.y));
    }
}

void drawEmission(const photons::PathSplit& split) {
    const auto& ranges = split.ranges;
    for (size_t first = 0; first < ranges.size();) {
        size_t end = first;
        uint32_t paths = 0;
        for (; end < ranges.size() && ranges[end].kind == ranges[first].kind &&
               ranges[end].index == ranges[first].index;
             ++end)
            paths += ranges[end].pathCount;
        ImGui::BeginGroup();
        drawEmitter(ranges, first, end);
        text(fmt::format("{} {}: {}",
                         ranges[first].kind == shared::EMIT_SURFACE ? "surface" : "light",
                         ranges[first].index, paths));
        ImGui::EndGroup();
        if (remainingWidth() > 2.5f * kSquare && end < ranges.size()) ImGui::SameLine();
        first = end;
    }
}

}  // namespace

void drawLightPanel(const FrameSeen& seen, const photons::PathSplit& split,
                    const photon_gi::Settings& settings, MarkChoice& choice, bool* open) {
    ImGui::SetNextWindowPos({60.0f, 220.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({430.0f, 460.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Photons", open)) {
        drawMarks(choice);
        drawStride(seen, choice);
        drawHeat(settings, choice);
        ImGui::Separator();
        drawCounts(seen);
        if (ImGui::CollapsingHeader("Guided emission: paths by their way out of each emitter"))
            drawEmission(split);
    }
    ImGui::End();
}

}  // namespace lampyris::overlay
