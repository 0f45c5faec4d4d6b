/// \file Components by name, and whole worlds as JSON text.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/result.h"
#include "ecs/world.h"

namespace lampyris::ecs {

/// How an entity is named in the file: by its place in the list, null for none or a dead one.
class SavedEntities {
 public:
    explicit SavedEntities(std::span<const Entity> inOrder);
    [[nodiscard]] nlohmann::json reference(Entity e) const;

 private:
    std::unordered_map<Entity, size_t> places_;
};

/// The way back; an error where the place does not exist.
class LoadedEntities {
 public:
    explicit LoadedEntities(std::vector<Entity> inOrder) : entities_(std::move(inOrder)) {}
    [[nodiscard]] core::Result<Entity> entity(const nlohmann::json& reference) const;
    [[nodiscard]] std::span<const Entity> all() const { return entities_; }

 private:
    std::vector<Entity> entities_;
};

/// Which components are saved, under which name. What is not registered is not saved (derived
/// values, for one).
class Registry {
 public:
    /// toJson: nlohmann::json(const C&); fromJson: Result<C>(const nlohmann::json&). A component
    /// that refers to entities takes a second argument: const SavedEntities& or const
    /// LoadedEntities&. An exception of nlohmann's that leaves fromJson becomes an error that names
    /// the entity and the component.
    template <Component C, typename ToJson, typename FromJson>
    void add(std::string name, ToJson toJson, FromJson fromJson) {
        insert(Entry{std::move(name), saver<C>(std::move(toJson)), loader<C>(std::move(fromJson))});
    }
    /// For a component with nlohmann's to_json and from_json.
    template <Component C>
    void add(std::string name) {
        add<C>(
            std::move(name), [](const C& value) { return nlohmann::json(value); },
            [](const nlohmann::json& json) -> core::Result<C> { return json.get<C>(); });
    }

    struct Entry {
        std::string name;
        std::function<std::optional<nlohmann::json>(const World&, Entity, const SavedEntities&)>
            save;
        std::function<core::Result<void>(World&, Entity, const nlohmann::json&,
                                         const LoadedEntities&)>
            load;
    };
    [[nodiscard]] const Entry* find(std::string_view name) const;
    [[nodiscard]] std::span<const Entry> entries() const { return entries_; }

 private:
    template <Component C, typename ToJson>
    static auto saver(ToJson toJson) {
        return [toJson = std::move(toJson)](
                   const World& world, Entity e,
                   const SavedEntities& saved) -> std::optional<nlohmann::json> {
            const C* value = world.find<C>(e);
            if (value == nullptr) return std::nullopt;
            if constexpr (std::is_invocable_v<ToJson, const C&, const SavedEntities&>) {
                return toJson(*value, saved);
            } else {
                return toJson(*value);
            }
        };
    }
    template <Component C, typename FromJson>
    static auto loader(FromJson fromJson) {
        return
            [fromJson = std::move(fromJson)](World& world, Entity e, const nlohmann::json& json,
                                             const LoadedEntities& loaded) -> core::Result<void> {
                const auto read = [&] {
                    if constexpr (std::is_invocable_v<FromJson, const nlohmann::json&,
                                                      const LoadedEntities&>) {
                        return fromJson(json, loaded);
                    } else {
                        return fromJson(json);
                    }
                };
                TRY(C value, read());
                world.set(e, std::move(value));
                return {};
            };
    }
    void insert(Entry entry);

    std::vector<Entry> entries_;
};

/// The world as JSON, parents before children; the same world gives the same text.
[[nodiscard]] std::string saveWorld(const World& world, const Registry& registry);

/// A new world from such text. Errors name the line and column, or the entity and the component,
/// that are wrong; a component that is not registered is an error too.
core::Result<World> loadWorld(std::string_view text, const Registry& registry);

}  // namespace lampyris::ecs
