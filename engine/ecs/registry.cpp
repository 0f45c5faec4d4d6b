#include "ecs/registry.h"

#include <algorithm>

#include "core/check.h"

namespace lampyris::ecs {

using nlohmann::json;

namespace {

constexpr const char* kFormat = "lampyris world";
constexpr int kVersion = 1;

std::string what(const json::exception& exception) {
    // "[json.exception.parse_error.101] parse error at …": the code in brackets tells a user
    // nothing.
    const std::string text = exception.what();
    const size_t end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

core::Result<json> parse(std::string_view text) {
    try {
        return json::parse(text);
    } catch (const json::exception& exception) {
        return core::error("world: {}", what(exception));
    }
}

core::Result<void> checkEnvelope(const json& root) {
    if (!root.is_object() || root.value("format", json()) != kFormat)
        return core::error("world: not an object with \"format\": \"{}\"", kFormat);
    if (root.value("version", json()) != kVersion)
        return core::error("world: version {} is not {}", root.value("version", json()).dump(),
                           kVersion);
    const auto entities = root.find("entities");
    if (entities == root.end() || !entities->is_array())
        return core::error("world: no list \"entities\"");
    if (entities->size() > Entity::kMaxEntities)
        return core::error("world: {} entities, but at most {} fit", entities->size(),
                           Entity::kMaxEntities);
    return {};
}

core::Result<void> loadComponent(World& world, Entity e, const std::string& name, const json& value,
                                 const Registry& registry, const LoadedEntities& loaded) {
    const Registry::Entry* entry = registry.find(name);
    if (entry == nullptr) return core::error("unknown component \"{}\"", name);
    try {
        const auto done = entry->load(world, e, value, loaded);
        if (!done.ok()) return core::error("component \"{}\": {}", name, done.error().message);
    } catch (const json::exception& exception) {
        return core::error("component \"{}\": {}", name, what(exception));
    }
    return {};
}

core::Result<void> loadEntity(World& world, Entity e, const json& entity, const Registry& registry,
                              const LoadedEntities& loaded) {
    if (!entity.is_object()) return core::error("not an object");
    for (const auto& [key, value] : entity.items()) {
        if (key == "parent") {
            TRY(const Entity parent, loaded.entity(value));
            if (parent.valid()) TRY_VOID(setParent(world, e, parent));
        } else if (key == "components" && value.is_object()) {
            for (const auto& [name, component] : value.items())
                TRY_VOID(loadComponent(world, e, name, component, registry, loaded));
        } else {
            return core::error("unexpected \"{}\"", key);
        }
    }
    return {};
}

}  // namespace

SavedEntities::SavedEntities(std::span<const Entity> inOrder) {
    for (const Entity e : inOrder) places_.emplace(e, places_.size());
}

json SavedEntities::reference(Entity e) const {
    const auto found = places_.find(e);
    return found == places_.end() ? json() : json(found->second);
}

core::Result<Entity> LoadedEntities::entity(const json& reference) const {
    if (reference.is_null()) return Entity{};
    if (!reference.is_number_unsigned() || reference.get<uint64_t>() >= entities_.size())
        return core::error("{} names none of the {} entities", reference.dump(), entities_.size());
    return entities_[reference.get<uint64_t>()];
}

void Registry::insert(Entry entry) {
    CHECK(find(entry.name) == nullptr);
    entries_.push_back(std::move(entry));
}

const Registry::Entry* Registry::find(std::string_view name) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& e) { return e.name == name; });
    return found == entries_.end() ? nullptr : &*found;
}

std::string saveWorld(const World& world, const Registry& registry) {
    const std::vector<Entity> order = parentsFirst(world);
    const SavedEntities saved(order);
    json entities = json::array();
    for (const Entity e : order) {
        json entity = {{"components", json::object()}};
        if (const Entity parent = parentOf(world, e); parent.valid())
            entity["parent"] = saved.reference(parent);
        for (const Registry::Entry& entry : registry.entries())
            if (auto value = entry.save(world, e, saved))
                entity["components"][entry.name] = std::move(*value);
        entities.push_back(std::move(entity));
    }
    const json root = {
        {"format", kFormat}, {"version", kVersion}, {"entities", std::move(entities)}};
    return root.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

core::Result<World> loadWorld(std::string_view text, const Registry& registry) {
    TRY(const json root, parse(text));
    TRY_VOID(checkEnvelope(root));
    const json& entities = root["entities"];
    World world;
    std::vector<Entity> created(entities.size());
    for (Entity& e : created) e = world.create();
    const LoadedEntities loaded(std::move(created));
    for (size_t i = 0; i < entities.size(); ++i) {
        const auto done = loadEntity(world, loaded.all()[i], entities[i], registry, loaded);
        if (!done.ok()) return core::error("world: entity {}: {}", i, done.error().message);
    }
    return world;
}

}  // namespace lampyris::ecs
