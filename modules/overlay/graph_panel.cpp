#include "overlay/graph_panel.h"
#include "overlay/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace lampyris::overlay {
namespace {

constexpr float kMemoryHeight = 180.0f;

std::string sizeText(uint64_t bytes) {
    if (bytes >= 10u << 20u) return fmt::format("{:.0f} MiB", static_cast<double>(bytes) / 1048576);
    if (bytes >= 10u << 10u) return fmt::format("{:.0f} KiB", static_cast<double>(bytes) / 1024);
    return fmt::format("{} B", bytes);
}

std::string kindText(const graph::ResourceInfo& info) {
    if (!info.isImage) return sizeText(info.buffer.bytes);
    const graph::ImageDesc& image = info.image;
    std::string words =
        fmt::format("{} {}x{}", graph::name(image.format), image.extent.width, image.extent.height);
    if (image.layers > 1) words += fmt::format(" x {}", image.layers);
    return words;
}

const char* originText(graph::Origin origin) {
    switch (origin) {
        case graph::Origin::Transient:
            return "transient";
        case graph::Origin::Imported:
            return "imported";
        case graph::Origin::History:
            return "history";
    }
    return "";
}

/// An image that is there before the overlay is drawn.
bool canBeLookedAt(const graph::ResourceInfo& info) {
    return info.isImage && info.name.rfind("overlay ", 0) != 0;
}

/// A name to click on; images are chosen to be looked at.
void nameOf(const graph::ResourceInfo& info, LookChoice& choice) {
    if (!canBeLookedAt(info)) return text(info.name);
    if (ImGui::Selectable(info.name.c_str(), choice.name == info.name))
        choice.name = choice.name == info.name ? std::string{} : info.name;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Click to look at it; what nobody needed is drawn for that");
}

void drawBarrier(const FrameSeen& seen, const graph::Barrier& barrier) {
    const std::string& name = seen.declared.resources()[barrier.resource].name;
    if (!barrier.isImage || barrier.before == barrier.after)
        ImGui::BulletText("barrier on %s", name.c_str());
    else
        ImGui::BulletText("barrier on %s, new layout%s", name.c_str(),
                          barrier.discards ? ", contents dropped" : "");
}

void drawStep(const FrameSeen& seen, const graph::Step& step, LookChoice& choice) {
    const graph::Node& node = seen.declared.nodes()[step.node];
    for (size_t i = 0; i < node.uses.size(); ++i) {
        const graph::Use& use = node.uses[i];
        const graph::ResourceInfo& info = seen.declared.resources()[use.resource];
        ImGui::PushID(static_cast<int>(i));
        ImGui::Bullet();
        text(fmt::format("{} v{}", graph::name(use.access), use.version));
        ImGui::SameLine();
        nameOf(info, choice);
        ImGui::PopID();
    }
    for (const graph::Barrier& barrier : step.barriers) drawBarrier(seen, barrier);
    for (const graph::Handover& handover : step.handover.handovers)
        ImGui::BulletText("memory of %s passes to %s",
                          seen.declared.resources()[handover.from].name.c_str(),
                          seen.declared.resources()[handover.to].name.c_str());
}

void drawNodes(const FrameSeen& seen, LookChoice& choice, std::optional<NodeName>& opened) {
    const auto& steps = seen.graph.steps;
    std::map<std::string, int> met;
    for (int i = 0; i < static_cast<int>(steps.size()); ++i) {
        const graph::Step& step = steps[static_cast<size_t>(i)];
        if (step.node == graph::kNoNode) continue;
        const graph::Node& node = seen.declared.nodes()[step.node];
        const NodeName name{node.name, met[node.name]++};
        // Steps move up and down, and barriers come and go, between a press and its release.
        ImGui::PushID(name.occurrence);
        const std::string label = fmt::format(
            "{:3} {} ({}), {} barriers###{}", i, node.name, graph::name(node.kind),
            step.barriers.size() + (step.handover.handovers.empty() ? 0 : 1), node.name);
        if (ImGui::Selectable(label.c_str(), opened == name))
            opened = opened == name ? std::nullopt : std::optional{name};
        if (opened == name) drawStep(seen, step, choice);
        ImGui::PopID();
    }
}

void drawCulled(const FrameSeen& seen) {
    if (seen.graph.culled.empty()) text("Every declared node runs.");
    for (const graph::CulledNode& culled : seen.graph.culled)
        ImGui::BulletText("%s: %s", seen.declared.nodes()[culled.node].name.c_str(),
                          culled.reason.c_str());
}

void drawResources(const FrameSeen& seen, LookChoice& choice) {
    if (!ImGui::BeginTable("resources", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable))
        return;
    for (const char* name : {"name", "what", "origin", "steps"}) ImGui::TableSetupColumn(name);
    ImGui::TableHeadersRow();
    for (size_t i = 0; i < seen.declared.resources().size(); ++i) {
        const graph::ResourceInfo& info = seen.declared.resources()[i];
        const graph::CompiledResource& made = seen.graph.resources[i];
        const bool idle = made.firstStep == graph::kNoStep;
        if (idle && !info.isImage) continue;
        ImGui::PushID(static_cast<int>(i));
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        nameOf(info, choice);
        ImGui::TableNextColumn();
        text(kindText(info));
        ImGui::TableNextColumn();
        text(originText(info.origin));
        ImGui::TableNextColumn();
        if (idle)
            ImGui::TextDisabled("not drawn");
        else
            text(fmt::format("{} to {}", made.firstStep, made.lastStep));
        ImGui::PopID();
    }
    ImGui::EndTable();
}

ImU32 colourFor(size_t number) {
    const float hue = static_cast<float>(number * 97 % 360) / 360.0f;
    return ImColor::HSV(hue, 0.55f, 0.75f);
}

/// Transients as boxes: steps from left to right, their place in the heap from top to bottom.
void drawHeap(const FrameSeen& seen, uint32_t heap, LookChoice& choice) {
    const auto bytes = static_cast<float>(std::max<uint64_t>(seen.graph.heaps[heap].bytes, 1));
    const auto steps = static_cast<float>(seen.graph.steps.size() + 1);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{remainingWidth(), kMemoryHeight};
    ImGui::InvisibleButton("memory", size);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect(corner, {corner.x + size.x, corner.y + size.y}, IM_COL32(120, 120, 120, 255));
    for (size_t i = 0; i < seen.graph.resources.size(); ++i) {
        const graph::CompiledResource& made = seen.graph.resources[i];
        if (made.heap != heap) continue;
        const float top = corner.y + size.y * static_cast<float>(made.offset) / bytes;
        const float left = corner.x + size.x * static_cast<float>(made.firstStep) / steps;
        const ImVec2 from{left, top};
        const ImVec2 to{corner.x + size.x * static_cast<float>(made.lastStep + 1) / steps,
                        std::max(top + size.y * static_cast<float>(made.bytes) / bytes, top + 1)};
        list.AddRectFilled(from, to, colourFor(i));
        const bool under = ImGui::IsItemHovered() && mouse.x >= from.x && mouse.x < to.x &&
                           mouse.y >= from.y && mouse.y < to.y;
        if (!under) continue;
        const graph::ResourceInfo& info = seen.declared.resources()[i];
        ImGui::SetTooltip("%s, %s, steps %u to %u", info.name.c_str(), sizeText(made.bytes).c_str(),
                          made.firstStep, made.lastStep);
        if (canBeLookedAt(info) && ImGui::IsMouseClicked(0)) choice.name = info.name;
    }
}

void drawMemory(const FrameSeen& seen, LookChoice& choice) {
    text(fmt::format(
        "transient {}, without aliasing {}; device {}", sizeText(seen.graph.transientBytes),
        sizeText(seen.graph.transientBytesWithoutAliasing), sizeText(seen.statistics.deviceBytes)));
    for (uint32_t i = 0; i < seen.graph.heaps.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        text(fmt::format("heap {}: {}; steps to the right, bytes downwards", i,
                         sizeText(seen.graph.heaps[i].bytes)));
        drawHeap(seen, i, choice);
        ImGui::PopID();
    }
}

}  // namespace

void GraphPanel::draw(const FrameSeen& seen, LookChoice& choice, bool* open) {
    ImGui::SetNextWindowPos({430.0f, 90.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({460.0f, 480.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Graph", open) && ImGui::BeginTabBar("graph")) {
        if (ImGui::BeginTabItem("Nodes")) {
            drawNodes(seen, choice, opened_);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("Images and buffers")) {
            drawResources(seen, choice);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("Memory")) {
            drawMemory(seen, choice);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("Culled")) {
            drawCulled(seen);
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
}

}  // namespace lampyris::overlay
