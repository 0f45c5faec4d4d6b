#include "fly_camera.h"

#include <algorithm>

#include "math/rigid.h"

namespace lampyris::sandbox {
namespace {

constexpr float kRadiansPerPixel = 0.004f;  // [chosen] half a turn across a wide window
constexpr float kSteepest = 0.99f;          // sine of the pitch; straight up has no heading

glm::vec3 direction(const window::Input& input) {
    const auto axis = [&](unsigned char forth, unsigned char back) {
        return static_cast<float>(input.held[forth]) - static_cast<float>(input.held[back]);
    };
    return {axis('D', 'A'), axis('E', 'Q'), axis('S', 'W')};
}

glm::mat3 turned(const glm::mat3& axes, float yaw, float pitch) {
    if (yaw == 0.0f && pitch == 0.0f) return axes;  // to the last bit: frames come to rest
    const glm::mat3 about = glm::mat3(glm::rotate(glm::mat4(1.0f), yaw, glm::vec3(0, 1, 0))) * axes;
    const glm::mat3 nodded =
        glm::mat3(glm::rotate(glm::mat4(1.0f), pitch, glm::vec3(about[0]))) * about;
    // Each product rounds, and always to the same side.
    return math::rigidPart(glm::mat4(std::abs(nodded[2].y) < kSteepest ? nodded : about));
}

}  // namespace

glm::mat4 fly(const glm::mat4& cameraToWorld, const window::Input& input, float metresPerSecond,
              float seconds) {
    glm::mat3 axes(cameraToWorld);
    if (input.buttons[0])
        axes = turned(axes, -kRadiansPerPixel * static_cast<float>(input.movedX),
                      -kRadiansPerPixel * static_cast<float>(input.movedY));
    const glm::vec3 step = axes * direction(input) * (metresPerSecond * seconds);
    glm::mat4 moved(axes);
    moved[3] = cameraToWorld[3] + glm::vec4(step, 0.0f);
    return moved;
}

}  // namespace lampyris::sandbox
