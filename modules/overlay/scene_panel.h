/// \file Scene: the tree of entities, and the chosen one's components, to be edited as they run.
#pragma once

#include <string>

#include "ecs/registry.h"
#include "ecs/world.h"

namespace lampyris::overlay {

class ScenePanel {
 public:
    /// The registry must outlive the panel. Components that it does not know are not shown.
    explicit ScenePanel(const ecs::Registry& registry) : registry_(&registry) {}

    /// Edits go into the world at once; what a component refuses is said, and changes nothing.
    /// \param selected  the chosen entity; none where it is dead
    void draw(ecs::World& world, ecs::Entity& selected, bool* open);

 private:
    void drawTree(const ecs::World& world, ecs::Entity entity, ecs::Entity& selected);
    void drawInspector(ecs::World& world, ecs::Entity entity);
    [[nodiscard]] bool matches(const ecs::World& world, ecs::Entity entity) const;

    const ecs::Registry* registry_;
    std::string filter_;   ///< part of a name
    std::string refused_;  ///< what the last edit met with
    ecs::Entity shown_;    ///< whose edit it was
};

}  // namespace lampyris::overlay
