/// \file What moves by the clock: components, and the systems that place their entities. All is a
/// function of FrameTime::seconds; what comes out as it was is not marked as changed.
#pragma once

#include <memory>

#include "courtyard/route.h"
#include "ecs/schedule.h"
#include "scene/components.h"

namespace lampyris::courtyard {

/// Turns to and fro about an axis.
struct Swing {
    glm::vec3 axis{0.0f, 0.0f, 1.0f};
    float turns = 0.05f;  ///< to either side
    float periodSeconds = 3.0f;
    float phaseTurns = 0.0f;
    float restTurns = 0.0f;  ///< around which it swings
};

/// Turns on and on.
struct Spin {
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    float turnsPerSecond = 0.1f;
};

/// A leaf that turns about y: shut, opening, open, shutting, a quarter of the period each.
struct Door {
    float openTurns = 0.25f;
    float periodSeconds = 12.0f;
};
/// 0 shut to 1 open.
[[nodiscard]] float openness(const Door& door, double seconds);

/// Goes round a route, facing forward (+z).
struct Travel {
    std::shared_ptr<const Route> route;
    float metresPerSecond = 1.0f;
    float startMetres = 0.0f;
};

/// A light whose power and radius swell and sink.
struct Pulse {
    glm::vec3 powerWatts{0.0f};  ///< in the middle
    float radiusMetres = 0.1f;
    float powerShare = 0.3f;   ///< of the power that comes and goes
    float radiusShare = 0.1f;  ///< of the radius
    float periodSeconds = 2.5f;
};

/// A wave through the mesh's morph targets: a sine and a cosine for each pair of them.
struct Ripple {
    float periodSeconds = 2.0f;  ///< of the first pair; that of pair k is k + 1 times as fast
    float weight = 1.0f;
};

/// Adds all these systems.
void addMovements(ecs::Schedule& systems);

}  // namespace lampyris::courtyard
