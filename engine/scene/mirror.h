/// \file A game's own storage, mirrored into an ecs::World: what the game keeps stays where it is,
/// and a frame edits only what changed since the last.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ecs/world.h"
#include "scene/components.h"

namespace lampyris::scene {

/// One thing of the game as it is now. What it has not got is left empty.
struct EntityState {
    /// The game's own number: of this thing alone, as long as it lives. One that another thing has
    /// at the very next follow() stands for the same entity, which keeps the Skin, MorphWeights and
    /// parent of the former.
    uint64_t id = 0;
    std::string_view name{};  ///< a camera is found by it
    Transform transform{};    ///< to the world; to the parent where the game gave it one there
    std::optional<MeshInstance> mesh{};
    std::optional<SphereLight> light{};
    std::optional<Camera> camera{};
};

/// What a game implements over its storage.
class EntitySource {
 public:
    virtual ~EntitySource() = default;
    /// Calls `show` once for everything that is there, in any order.
    virtual void forEach(const std::function<void(const EntityState&)>& show) const = 0;
};

/// The entities that stand for a source's things in one world. They are the world's like all
/// others: a Skin, MorphWeights or a parent that the game gives one of them stays; one whose parent
/// leaves while it is still shown goes on without. What else hangs on an entity goes with it.
class Mirror {
 public:
    struct Counts {
        uint32_t added = 0;
        uint32_t changed = 0;  ///< in at least one component
        uint32_t removed = 0;

        bool operator==(const Counts&) const = default;
    };

    /// Makes, edits and destroys entities until they are as the source says. What is as it was is
    /// looked at but not touched, so it carries no new tick. Meshes and materials are those of the
    /// world's Library. Source and world are the same at every call. An id that comes twice in one
    /// call fails a CHECK.
    ///   reads   source      writes  Name, Transform, MeshInstance, SphereLight, Camera
    Counts follow(ecs::World& world, const EntitySource& source);

    /// None where no such thing was shown at the last follow().
    [[nodiscard]] ecs::Entity entityOf(uint64_t id) const;

 private:
    struct Known {
        ecs::Entity entity;
        uint64_t round = 0;  ///< in which it was last shown
    };
    void show(ecs::World& world, const EntityState& state, Counts& counts);
    /// Destroys entities, but none that is still known.
    void remove(ecs::World& world, const std::vector<ecs::Entity>& gone) const;

    std::unordered_map<uint64_t, Known> known_;
    uint64_t round_ = 0;
};

}  // namespace lampyris::scene
