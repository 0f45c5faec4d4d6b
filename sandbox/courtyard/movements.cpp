#include "courtyard/movements.h"

#include <cmath>

#include "courtyard/forms.h"
#include "scene/builtin/numbers.h"
#include "scene/motion.h"
#include "scene/spawn.h"

namespace lampyris::courtyard {

using scene::FrameTime;
using scene::SphereLight;
using scene::Transform;
using scene::builtin::sinCosTurns;

float openness(const Door& door, double seconds) {
    const double turns = seconds / door.periodSeconds;
    const double quarters = 4.0 * (turns - std::floor(turns));
    const double t = glm::clamp(quarters < 3.0 ? quarters - 1.0 : 4.0 - quarters, 0.0, 1.0);
    return static_cast<float>(t * t * (3.0 - 2.0 * t));
}

namespace {

void setRotation(ecs::Write<Transform>& transform, const glm::quat& rotation) {
    if (transform.get().rotation != rotation) transform->rotation = rotation;
}

void swing(ecs::Write<Transform> transform, ecs::Read<Swing> swing, const FrameTime& time) {
    const double way = sinCosTurns(time.seconds / swing->periodSeconds + swing->phaseTurns).sin;
    setRotation(transform, turned(swing->axis, swing->restTurns + swing->turns * way));
}

void spin(ecs::Write<Transform> transform, ecs::Read<Spin> spin, const FrameTime& time) {
    const double turns = time.seconds * spin->turnsPerSecond;
    setRotation(transform, turned(spin->axis, turns - std::floor(turns)));
}

void turnDoor(ecs::Write<Transform> transform, ecs::Read<Door> door, const FrameTime& time) {
    const float open = openness(*door, time.seconds);
    setRotation(transform, turned({0.0f, 1.0f, 0.0f}, open * door->openTurns));
}

void travel(ecs::Write<Transform> transform, ecs::Read<Travel> travel, const FrameTime& time) {
    const Stance stance =
        travel->route->at(travel->startMetres + time.seconds * travel->metresPerSecond);
    if (transform.get().translation != stance.position) transform->translation = stance.position;
    setRotation(transform, scene::rotationFacing(stance.forward));
}

void pulse(ecs::Write<SphereLight> light, ecs::Read<Pulse> pulse, const FrameTime& time) {
    const auto way = static_cast<float>(sinCosTurns(time.seconds / pulse->periodSeconds).sin);
    light->powerWatts = pulse->powerWatts * (1.0f + pulse->powerShare * way);
    light->radiusMetres = pulse->radiusMetres * (1.0f + pulse->radiusShare * way);
}

void ripple(ecs::Write<scene::MorphWeights> weights, ecs::Read<Ripple> ripple,
            const FrameTime& time) {
    auto& values = weights->values;
    for (size_t i = 0; i < values.size(); ++i) {
        const size_t harmonic = i / 2 + 1;
        const auto wave =
            sinCosTurns(time.seconds * static_cast<double>(harmonic) / ripple->periodSeconds);
        values[i] = ripple->weight * static_cast<float>(i % 2 == 0 ? wave.sin : wave.cos);
    }
}

}  // namespace

void addMovements(ecs::Schedule& systems) {
    systems.add("swing", swing);
    systems.add("spin", spin);
    systems.add("turn doors", turnDoor);
    systems.add("travel", travel);
    systems.add("pulse", pulse);
    systems.add("ripple", ripple);
}

}  // namespace lampyris::courtyard
