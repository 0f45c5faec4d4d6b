#include "view/walk_camera.h"

#include <algorithm>

#include "fly_camera.h"
#include "scene/ray_cast.h"

namespace lampyris::sandbox::view {
namespace {

constexpr float kMetresPerSecond = 2.5f;  // [chosen] a brisk walk; with Shift a run
constexpr float kRun = 2.5f;
constexpr float kGravity = 9.81f;
constexpr float kStepMetres = 0.5f;   // [chosen] what is climbed without a jump
constexpr float kBodyMetres = 0.35f;  // [chosen] how near a wall lets the eye

/// The step, less what would lead into a wall.
glm::vec3 heldUp(const scene::SceneSnapshot& snapshot, const glm::vec3& eye, glm::vec3 step) {
    // Twice: along one wall into the next.
    for (int i = 0; i < 2; ++i) {
        const float length = glm::length(step);
        if (length <= 0.0f) return step;
        const glm::vec3 knee = eye - glm::vec3(0, WalkCamera::kEyeMetres - kStepMetres, 0);
        for (const glm::vec3& from : {eye, knee}) {
            const auto wall = scene::castRay(snapshot, from, step / length, length + kBodyMetres);
            if (!wall) continue;
            glm::vec3 across = wall->normalWorld;
            across.y = 0.0f;
            if (glm::length(across) < 0.1f) continue;  // a floor or a ceiling
            across = glm::normalize(across);
            step -= std::min(glm::dot(step, across), 0.0f) * across;
            break;
        }
    }
    return step;
}

/// The height of an eye that stands there; its own over no ground, where it hovers.
float standingAt(const scene::SceneSnapshot& snapshot, const glm::vec3& eye) {
    const auto ground = scene::castRay(snapshot, eye, glm::vec3(0, -1, 0));
    return ground ? ground->positionWorld.y + WalkCamera::kEyeMetres : eye.y;
}

}  // namespace

glm::mat4 WalkCamera::walk(const glm::mat4& cameraToWorld, const window::Input& input,
                           const scene::SceneSnapshot& snapshot, float seconds) {
    // Turned as in flight, but not moved.
    window::Input turning = input;
    turning.held.fill(false);
    glm::mat4 camera = fly(cameraToWorld, turning, 0.0f, seconds);
    const auto axis = [&](unsigned char forth, unsigned char back) {
        return static_cast<float>(input.held[forth]) - static_cast<float>(input.held[back]);
    };
    const glm::vec3 level(camera[0].x, 0.0f, camera[0].z);
    const glm::vec3 right =
        glm::length(level) > 1e-3f ? glm::normalize(level) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 ahead(right.z, 0.0f, -right.x);
    glm::vec3 wish = axis('D', 'A') * right + axis('W', 'S') * ahead;
    if (glm::length(wish) > 1.0f) wish = glm::normalize(wish);
    const float pace = kMetresPerSecond * (input.shift() ? kRun : 1.0f);
    glm::vec3 eye(camera[3]);
    const glm::vec3 step = heldUp(snapshot, eye, wish * (pace * seconds));
    const float height = eye.y;
    float floor = standingAt(snapshot, eye + step);
    if (step != glm::vec3(0.0f) && floor > height + kStepMetres)
        floor = standingAt(snapshot, eye);  // a table, say
    else
        eye += step;
    fallMetresPerSecond_ = eye.y > floor ? fallMetresPerSecond_ + kGravity * seconds : 0.0f;
    eye.y = std::max(floor, eye.y - fallMetresPerSecond_ * seconds);
    if (eye.y <= floor) fallMetresPerSecond_ = 0.0f;
    camera[3] = glm::vec4(eye, 1.0f);
    return camera;
}

}  // namespace lampyris::sandbox::view
