#include "overlay/image_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "overlay/panel_node.h"
#include "overlay/words.h"

namespace lampyris::overlay {
namespace {

constexpr std::array kChannels{"red", "green", "blue", "alpha", "colour", "numbered"};

void drawChoice(LookChoice& choice, const graph::ImageDesc& desc) {
    int channel = static_cast<int>(choice.channel);
    ImGui::SetNextItemWidth(90.0f);
    if (ImGui::Combo("channel", &channel, kChannels.data(), static_cast<int>(kChannels.size())))
        choice.channel = static_cast<uint32_t>(channel);
    ImGui::SameLine();
    ImGui::Checkbox("whole range", &choice.wholeRange);
    ImGui::SameLine();
    ImGui::Checkbox("sRGB", &choice.encode);
    ImGui::SetNextItemWidth(160.0f);
    ImGui::SliderFloat("exposure, EV", &choice.exposureEv, -16.0f, 16.0f, "%.1f");
    if (desc.layers > 1) {
        int layer = static_cast<int>(choice.layer);
        ImGui::SliderInt("layer", &layer, 0, static_cast<int>(desc.layers) - 1);
        choice.layer = static_cast<uint32_t>(layer);
    }
}

void drawPicture(LookChoice& choice, const graph::ImageDesc& desc) {
    const float width = std::max(remainingWidth(), 64.0f);
    const auto [columns, rows] = desc.extent;
    const float height = width * static_cast<float>(rows) / static_cast<float>(columns);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Image(pictureTexture(), {width, height});
    choice.cursor.reset();
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto texel = [](float share, uint32_t count) {
        const auto at = static_cast<int64_t>(share * static_cast<float>(count));
        return static_cast<uint32_t>(std::clamp<int64_t>(at, 0, int64_t{count} - 1));
    };
    choice.cursor = {texel((mouse.x - corner.x) / width, columns),
                     texel((mouse.y - corner.y) / height, rows)};
}

void drawFindings(const ImageLook& look) {
    const shared::LookFindings* const found = look.findings();
    if (found == nullptr) return;
    if (look.cursor()) {
        const glm::vec4 v = found->underCursor;
        const glm::uvec4 bits = found->bitsUnderCursor;
        const glm::uvec2 at = *look.cursor();
        const graph::Format format = look.desc().format;
        const bool whole = format == graph::Format::R32Uint || format == graph::Format::RGBA32Uint;
        text(whole
                 ? fmt::format("({}, {}): {} {} {} {}", at.x, at.y, bits.x, bits.y, bits.z, bits.w)
                 : fmt::format("({}, {}): {:.5g} {:.5g} {:.5g} {:.5g}", at.x, at.y, v.x, v.y, v.z,
                               v.w));
    } else {
        text("point at it for a texel's value");
    }
    const auto [least, most] = look.range();
    text(fmt::format("from {:.5g} to {:.5g}", least, most));
    if (found->notFinite > 0)
        ImGui::TextColored(kAlarm, "%u texels are not finite", found->notFinite);
    const uint32_t channel = look.choice.channel;
    std::array<float, shared::LOOK_BINS> bins{};
    for (uint32_t c = 0; c < shared::LOOK_CHANNELS; ++c) {
        if (channel < shared::LOOK_COLOUR ? c != channel : c > 2) continue;
        for (uint32_t i = 0; i < shared::LOOK_BINS; ++i)
            bins[i] += static_cast<float>(found->bins[c * shared::LOOK_BINS + i]);
    }
    ImGui::PlotHistogram("##histogram", bins.data(), static_cast<int>(bins.size()), 0,
                         "histogram of what is shown", 0.0f, FLT_MAX, {remainingWidth(), 70.0f});
}

}  // namespace

void drawImagePanel(ImageLook& look) {
    if (look.choice.name.empty()) return;
    bool open = true;
    ImGui::SetNextWindowPos({260.0f, 180.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({480.0f, 420.0f}, ImGuiCond_FirstUseEver);
    const std::string title = "Image: " + look.choice.name + "###image";
    const bool unfolded = ImGui::Begin(title.c_str(), &open);
    if (unfolded && look.isMissing()) {
        text("not in this frame");
    } else if (unfolded) {
        const graph::ImageDesc& desc = look.desc();
        text(fmt::format("{} {}x{}, {} layers", graph::name(desc.format), desc.extent.width,
                         desc.extent.height, desc.layers));
        drawChoice(look.choice, desc);
        drawPicture(look.choice, desc);
        drawFindings(look);
    }
    ImGui::End();
    if (!open) look.choice.name.clear();
}

}  // namespace lampyris::overlay
