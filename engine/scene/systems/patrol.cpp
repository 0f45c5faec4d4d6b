#include "scene/systems/patrol.h"

#include <algorithm>
#include <cmath>

namespace lampyris::scene {

namespace {

/// From one waypoint to the next, and for a closed way from the last to the first.
size_t legCount(const Patrol& patrol) {
    return patrol.closed ? patrol.waypoints.size() : patrol.waypoints.size() - 1;
}

double legMetres(const Patrol& patrol, size_t leg) {
    const glm::dvec3 from(patrol.waypoints[leg]);
    return glm::distance(from, glm::dvec3(patrol.waypoints[(leg + 1) % patrol.waypoints.size()]));
}

/// Metres along the way, from 0 to its length; walked to and fro where it is open.
double placeOnWay(const Patrol& patrol, double walked, double length) {
    const double round = patrol.closed ? length : 2.0 * length;
    double place = std::fmod(walked, round);
    if (place < 0.0) place += round;
    return place > length ? round - place : place;
}

glm::vec3 positionAt(const Patrol& patrol, double seconds) {
    double length = 0.0;
    for (size_t leg = 0; leg < legCount(patrol); ++leg) length += legMetres(patrol, leg);
    const double walked =
        (seconds - patrol.startSeconds) * static_cast<double>(patrol.metresPerSecond);
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(walked))
        return patrol.waypoints.front();
    double left = placeOnWay(patrol, walked, length);
    size_t leg = 0;
    while (leg + 1 < legCount(patrol) && left >= legMetres(patrol, leg))
        left -= legMetres(patrol, leg++);
    const double metres = legMetres(patrol, leg);
    const double share = metres > 0.0 ? std::min(left / metres, 1.0) : 0.0;
    const glm::dvec3 to(patrol.waypoints[(leg + 1) % patrol.waypoints.size()]);
    return glm::vec3(glm::mix(glm::dvec3(patrol.waypoints[leg]), to, share));
}

}  // namespace

void patrol(ecs::Write<Transform> transform, ecs::Read<Patrol> patrol, const FrameTime& time) {
    if (patrol->waypoints.empty()) return;
    const glm::vec3 position = positionAt(*patrol, time.seconds);
    if (transform.get().translation != position) transform->translation = position;
}

}  // namespace lampyris::scene
