#include "overlay/scene_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <nlohmann/json.hpp>

#include "ecs/hierarchy.h"
#include "overlay/json_fields.h"
#include "overlay/words.h"
#include "scene/library.h"

namespace lampyris::overlay {
namespace {

constexpr float kTreeHeight = 220.0f;

std::string nameOf(const ecs::World& world, ecs::Entity entity) {
    const auto* name = world.find<scene::Name>(entity);
    std::string words =
        name == nullptr || name->value.empty() ? std::string{"entity"} : name->value;
    if (world.has<scene::SphereLight>(entity)) words += " (light)";
    if (world.has<scene::Camera>(entity)) words += " (camera)";
    return words;
}

/// Whether the library has what the entity shows.
core::Result<void> checkNumbers(const ecs::World& world, ecs::Entity entity) {
    const auto* shown = world.find<scene::MeshInstance>(entity);
    const auto* library = world.findResource<scene::Library>();
    if (shown == nullptr || library == nullptr) return {};
    if (shown->mesh.valid() && shown->mesh.value >= library->meshes().size())
        return core::error("there are {} meshes", library->meshes().size());
    if (shown->material.valid() && shown->material.value >= library->materials().size())
        return core::error("there are {} materials", library->materials().size());
    return {};
}

ImGuiTreeNodeFlags flagsOf(bool isLeaf, bool isSelected) {
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth;
    if (isLeaf) flags |= ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_NoTreePushOnOpen;
    if (isSelected) flags |= ImGuiTreeNodeFlags_Selected;
    return flags;
}

}  // namespace

bool ScenePanel::matches(const ecs::World& world, ecs::Entity entity) const {
    return filter_.empty() || nameOf(world, entity).find(filter_) != std::string::npos;
}

void ScenePanel::draw(ecs::World& world, ecs::Entity& selected, bool* open) {
    ImGui::SetNextWindowPos({890.0f, 180.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({380.0f, 560.0f}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Scene", open)) {
        if (!world.alive(selected)) selected = {};
        ecs::Entity clicked = selected;
        ImGui::InputText("find", &filter_);
        ImGui::BeginChild("tree", {0.0f, kTreeHeight}, true);
        for (const ecs::Entity entity : ecs::parentsFirst(world)) {
            const bool root = !world.alive(ecs::parentOf(world, entity));
            if (filter_.empty() ? root : matches(world, entity)) drawTree(world, entity, clicked);
        }
        ImGui::EndChild();
        // Before another is chosen, so that a field that is left for it keeps what was typed.
        if (world.alive(selected)) drawInspector(world, selected);
        selected = clicked;
    }
    ImGui::End();
}

void ScenePanel::drawTree(const ecs::World& world, ecs::Entity entity, ecs::Entity& selected) {
    const auto children =
        filter_.empty() ? ecs::childrenOf(world, entity) : std::span<const ecs::Entity>{};
    ImGui::PushID(static_cast<int>(entity.index()));
    const bool isOpen = ImGui::TreeNodeEx("node", flagsOf(children.empty(), entity == selected),
                                          "%s", nameOf(world, entity).c_str());
    if (ImGui::IsItemClicked()) selected = entity == selected ? ecs::Entity{} : entity;
    if (isOpen && !children.empty()) {
        for (const ecs::Entity child : children) drawTree(world, child, selected);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

void ScenePanel::drawInspector(ecs::World& world, ecs::Entity entity) {
    ImGui::PushID(static_cast<int>(entity.index()));
    if (entity != shown_) refused_.clear();
    shown_ = entity;
    const std::vector<ecs::Entity> all = ecs::parentsFirst(world);
    const ecs::SavedEntities saved(all);
    for (const ecs::Registry::Entry& entry : registry_->entries()) {
        auto value = entry.save(world, entity, saved);
        if (!value || !ImGui::CollapsingHeader(entry.name.c_str(), ImGuiTreeNodeFlags_DefaultOpen))
            continue;
        ImGui::PushID(entry.name.c_str());
        ImGui::PushItemWidth(remainingWidth() * 0.6f);
        const nlohmann::json before = *value;
        if (editFields(*value)) {
            const ecs::LoadedEntities entities{all};
            auto loaded = entry.load(world, entity, *value, entities);
            if (loaded.ok()) loaded = checkNumbers(world, entity);
            if (!loaded.ok()) (void)entry.load(world, entity, before, entities);
            refused_ = loaded.ok() ? std::string{} : loaded.error().message;
        }
        ImGui::PopItemWidth();
        ImGui::PopID();
    }
    if (const auto* at = world.find<scene::WorldTransform>(entity)) {
        const glm::vec3 position(at->matrix[3]);
        ImGui::Text("in the world at %.3f %.3f %.3f m", static_cast<double>(position.x),
                    static_cast<double>(position.y), static_cast<double>(position.z));
    }
    if (!refused_.empty()) ImGui::TextColored(kAlarm, "refused: %s", refused_.c_str());
    ImGui::PopID();
}

}  // namespace lampyris::overlay
