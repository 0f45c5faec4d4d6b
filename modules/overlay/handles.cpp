#include "overlay/handles.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "deferred/view.h"
#include "ecs/hierarchy.h"
#include "scene/components.h"

namespace lampyris::overlay {
namespace {

constexpr float kLengthPixels = 90.0f;
constexpr float kReachPixels = 8.0f;  // [chosen] how near the mouse must be
// [chosen] Square of the sine of 6°: an axis looked at so has no length to drag.
constexpr float kEndOn = 0.01f;
constexpr int kCirclePoints = 48;
constexpr std::array<ImU32, 3> kColours{IM_COL32(235, 70, 60, 255), IM_COL32(90, 210, 80, 255),
                                        IM_COL32(80, 130, 245, 255)};
constexpr ImU32 kHot = IM_COL32(255, 230, 90, 255);

/// Where the handles stand, and how the screen sees them.
struct Stand {
    shared::View view;
    glm::mat4 cameraToWorld{1.0f};
    glm::vec3 origin{0.0f};
    std::array<glm::vec3, 3> axes{};  ///< unit, world
    float length = 1.0f;              ///< metres that are kLengthPixels

    [[nodiscard]] std::optional<ImVec2> screen(const glm::vec3& world) const {
        const glm::vec4 clip = view.worldToClip * glm::vec4(world, 1.0f);
        if (clip.w <= 1e-4f) return std::nullopt;
        return ImVec2{(clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(view.width),
                      (clip.y / clip.w * 0.5f + 0.5f) * static_cast<float>(view.height)};
    }
    /// Direction of the ray through a pixel.
    [[nodiscard]] glm::vec3 ray(const ImVec2& pixel) const {
        const glm::vec3 local(
            (2.0f * pixel.x / static_cast<float>(view.width) - 1.0f) / view.projection.x,
            (1.0f - 2.0f * pixel.y / static_cast<float>(view.height)) / view.projection.y, -1.0f);
        return glm::normalize(glm::mat3(cameraToWorld) * local);
    }
};

float distanceToSegment(const ImVec2& p, const ImVec2& a, const ImVec2& b) {
    const glm::vec2 ab(b.x - a.x, b.y - a.y);
    const glm::vec2 ap(p.x - a.x, p.y - a.y);
    const float t = glm::clamp(glm::dot(ap, ab) / std::max(glm::dot(ab, ab), 1e-6f), 0.0f, 1.0f);
    return glm::length(ap - t * ab);
}

/// Metres along the axis to the point nearest to the mouse's ray; nothing where it is seen end-on.
std::optional<float> alongAxis(const Stand& stand, int axis, const ImVec2& mouse) {
    const glm::vec3 direction = stand.ray(mouse);
    const glm::vec3 between = glm::vec3(stand.cameraToWorld[3]) - stand.origin;
    const glm::vec3& a = stand.axes[static_cast<size_t>(axis)];
    const float ad = glm::dot(a, direction);
    const float parallel = 1.0f - ad * ad;
    if (parallel < kEndOn) return std::nullopt;
    return (glm::dot(a, between) - ad * glm::dot(direction, between)) / parallel;
}

/// Radians about the axis of the mouse as seen from the origin, counter-clockwise from its tip.
std::optional<float> aboutAxis(const Stand& stand, int axis, const ImVec2& mouse) {
    const auto centre = stand.screen(stand.origin);
    if (!centre) return std::nullopt;
    const glm::vec3 toEye = glm::vec3(stand.cameraToWorld[3]) - stand.origin;
    const float facing = glm::dot(stand.axes[static_cast<size_t>(axis)], toEye);
    const float angle = std::atan2(centre->y - mouse.y, mouse.x - centre->x);
    return facing >= 0.0f ? angle : -angle;
}

/// The axis as lines on the screen: a shaft, or a circle about it.
std::vector<ImVec2> outline(const Stand& stand, HandleKind kind, int axis) {
    std::vector<ImVec2> points;
    const auto add = [&](const glm::vec3& offset) {
        if (const auto at = stand.screen(stand.origin + stand.length * offset))
            points.push_back(*at);
    };
    const auto a = static_cast<size_t>(axis);
    if (kind != HandleKind::Rotate) {
        add(glm::vec3(0.0f));
        add(stand.axes[a]);
        return points;
    }
    for (int i = 0; i <= kCirclePoints; ++i) {
        const float angle = 2.0f * math::kPi * static_cast<float>(i) / kCirclePoints;
        add(std::cos(angle) * stand.axes[(a + 1) % 3] + std::sin(angle) * stand.axes[(a + 2) % 3]);
    }
    return points;
}

bool isNear(const std::vector<ImVec2>& points, const ImVec2& mouse) {
    for (size_t i = 0; i + 1 < points.size(); ++i)
        if (distanceToSegment(mouse, points[i], points[i + 1]) < kReachPixels) return true;
    return false;
}

void drawOutline(const std::vector<ImVec2>& points, HandleKind kind, ImU32 colour) {
    if (points.size() < 2) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 3.0f);
    const ImVec2 tip = points.back();
    if (kind == HandleKind::Move) list.AddCircleFilled(tip, 6.0f, colour);
    if (kind == HandleKind::Scale)
        list.AddRectFilled({tip.x - 5, tip.y - 5}, {tip.x + 5, tip.y + 5}, colour);
}

glm::mat4 parentToWorld(const ecs::World& world, ecs::Entity entity) {
    const auto* at = world.find<scene::WorldTransform>(ecs::parentOf(world, entity));
    return at == nullptr ? glm::mat4(1.0f) : at->matrix;
}

void apply(ecs::World& world, ecs::Entity entity, HandleKind kind, const glm::vec3& axisWorld,
           int axis, float from, float to) {
    scene::Transform transform = world.get<scene::Transform>(entity);
    const glm::mat3 linear(parentToWorld(world, entity));
    const glm::mat3 toParent = glm::inverse(linear);
    if (kind == HandleKind::Move) {
        transform.translation += toParent * (axisWorld * (to - from));
    } else if (kind == HandleKind::Rotate) {
        const glm::vec3 about = glm::normalize(toParent * axisWorld);
        // Under a parent that mirrors, what turns one way in the world turns the other way.
        const float angle = (to - from) * glm::sign(glm::determinant(linear));
        transform.rotation = glm::normalize(glm::angleAxis(angle, about) * transform.rotation);
    } else {
        const float factor =
            std::abs(from) > 1e-4f ? std::clamp(std::abs(to / from), 0.1f, 10.0f) : 1.0f;
        if (const auto* light = world.find<scene::SphereLight>(entity)) {
            scene::SphereLight scaled = *light;
            scaled.radiusMetres = std::max(1e-3f, scaled.radiusMetres * factor);
            world.set(entity, scaled);
            return;
        }
        transform.scale[axis] *= factor;
    }
    const glm::vec3 sum = transform.translation + transform.scale;
    const float all = sum.x + sum.y + sum.z + glm::length(transform.rotation);
    if (std::isfinite(all)) world.set(entity, transform);  // a flat parent gives no way back
}

std::optional<Stand> standOf(const glm::mat4& objectToWorld, HandleKind kind,
                             const scene::SnapshotCamera& camera, graph::Extent size) {
    Stand stand{deferred::makeView(camera, size),
                camera.cameraToWorld,
                glm::vec3(objectToWorld[3]),
                {},
                1.0f};
    for (int i = 0; i < 3; ++i) {
        glm::vec3 axis(0.0f);
        axis[i] = 1.0f;
        if (kind == HandleKind::Scale) axis = glm::mat3(objectToWorld) * axis;
        const float length = glm::length(axis);
        stand.axes[static_cast<size_t>(i)] = length > 0.0f ? axis / length : axis;
    }
    const float depth = -(stand.view.worldToView * glm::vec4(stand.origin, 1.0f)).z;
    if (depth <= camera.nearMetres) return std::nullopt;
    stand.length =
        kLengthPixels * 2.0f * depth / (stand.view.projection.y * static_cast<float>(size.height));
    return stand;
}

}  // namespace

bool Handles::draw(ecs::World& world, ecs::Entity entity, const scene::SnapshotCamera& camera,
                   graph::Extent size) {
    const auto* at = world.find<scene::WorldTransform>(entity);
    if (!ImGui::IsMouseDown(0) || at == nullptr) dragged_.reset();
    if (dragged_ && (dragged_->entity != entity || dragged_->kind != kind)) dragged_.reset();
    if (at == nullptr || !world.has<scene::Transform>(entity)) return false;
    const auto stand = standOf(at->matrix, kind, camera, size);
    if (!stand) return dragging();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto valueOf = [&](int axis) {
        return kind == HandleKind::Rotate ? aboutAxis(*stand, axis, mouse)
                                          : alongAxis(*stand, axis, mouse);
    };
    int hot = dragged_ ? dragged_->axis : -1;
    for (int i = 0; i < 3; ++i) {
        const auto points = outline(*stand, kind, i);
        if (hot < 0 && !ImGui::GetIO().WantCaptureMouse && isNear(points, mouse) && valueOf(i))
            hot = i;
        drawOutline(points, kind, i == hot ? kHot : kColours[static_cast<size_t>(i)]);
    }
    if (!dragged_ && hot >= 0 && ImGui::IsMouseClicked(0))
        dragged_ = Drag{entity, kind, hot, *valueOf(hot)};
    if (!dragged_) return hot >= 0;
    const int axis = dragged_->axis;
    const std::optional<float> now = valueOf(axis);
    if (!now || *now == dragged_->start) return true;
    apply(world, entity, kind, stand->axes[static_cast<size_t>(axis)], axis, dragged_->start, *now);
    // What was moved takes its axis along, so the same place on it is under the mouse.
    if (kind != HandleKind::Move) dragged_->start = *now;
    return true;
}

}  // namespace lampyris::overlay
