/// \file Handles over the chosen entity, by which it is moved, turned and scaled.
#pragma once

#include <optional>

#include "ecs/world.h"
#include "graph/resource.h"
#include "scene/snapshot.h"

namespace lampyris::overlay {

enum class HandleKind : uint8_t { Move, Rotate, Scale };

/// Three axes of the world (of the entity, for scaling) through the entity's origin.
class Handles {
 public:
    HandleKind kind = HandleKind::Move;

    /// Draws them and follows the mouse, between Overlay::begin() and addNode(); edits Transform,
    /// or a light's radius where it is scaled. Nothing for an entity without a Transform.
    /// True while the mouse is theirs: it points at one, or drags it. An axis that is seen end-on
    /// has no length to point at; one that is dragged stays where it was until it has some again.
    bool draw(ecs::World& world, ecs::Entity entity, const scene::SnapshotCamera& camera,
              graph::Extent size);
    [[nodiscard]] bool dragging() const { return dragged_.has_value(); }

 private:
    struct Drag {
        ecs::Entity entity;
        HandleKind kind = HandleKind::Move;
        int axis = 0;
        float start = 0.0f;  ///< metres along the axis, or radians about it, where it was taken
    };
    std::optional<Drag> dragged_;
};

}  // namespace lampyris::overlay
