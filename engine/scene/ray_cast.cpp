#include "scene/ray_cast.h"

#include <algorithm>
#include <cmath>

namespace lampyris::scene {
namespace {

struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f};  ///< its length is the unit of distances
};

bool meets(const Ray& ray, const math::Bounds& bounds, float most) {
    if (bounds.empty()) return false;
    float enter = 0.0f;
    float leave = most;
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse = 1.0f / ray.direction[axis];
        float near = (bounds.lower[axis] - ray.origin[axis]) * inverse;
        float far = (bounds.upper[axis] - ray.origin[axis]) * inverse;
        if (near > far) std::swap(near, far);
        // A ray within a face gives NaN, which these leave out.
        enter = std::max(enter, std::isnan(near) ? enter : near);
        leave = std::min(leave, std::isnan(far) ? leave : far);
    }
    return enter <= leave * 1.00001f;
}

/// [Möller and Trumbore 1997] Infinity where it misses.
float crossTriangle(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    constexpr float kMiss = std::numeric_limits<float>::infinity();
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const glm::vec3 across = glm::cross(ray.direction, ac);
    const float scale = glm::dot(ab, across);
    if (scale == 0.0f) return kMiss;
    const glm::vec3 toOrigin = ray.origin - a;
    const float u = glm::dot(toOrigin, across) / scale;
    const glm::vec3 along = glm::cross(toOrigin, ab);
    const float v = glm::dot(ray.direction, along) / scale;
    const float t = glm::dot(ac, along) / scale;
    return u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > 0.0f ? t : kMiss;
}

float crossSphere(const Ray& ray, const glm::vec3& centre, float radius) {
    const glm::vec3 toCentre = centre - ray.origin;
    const float along = glm::dot(toCentre, ray.direction);
    const float beside = glm::dot(toCentre, toCentre) - along * along;
    const float half = radius * radius - beside;
    if (half < 0.0f || along - std::sqrt(half) <= 0.0f)
        return std::numeric_limits<float>::infinity();
    return along - std::sqrt(half);
}

void castAtInstance(const SceneSnapshot& snapshot, const SnapshotInstance& instance, const Ray& ray,
                    float& most, std::optional<RayCastHit>& hit) {
    const assets::Mesh& mesh = *snapshot.meshes[instance.mesh].value;
    // Distances stay the world's: the direction is not made unit again.
    const glm::mat4 toObject = glm::inverse(instance.objectToWorld);
    const Ray local{glm::vec3(toObject * glm::vec4(ray.origin, 1.0f)),
                    glm::mat3(toObject) * ray.direction};
    std::vector<glm::vec3> posed;
    if (instance.pose) posed = posedVertices(mesh, *instance.pose).positions;
    const std::vector<glm::vec3>& points = instance.pose ? posed : mesh.positions;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3& a = points[mesh.indices[i]];
        const glm::vec3& b = points[mesh.indices[i + 1]];
        const glm::vec3& c = points[mesh.indices[i + 2]];
        const float t = crossTriangle(local, a, b, c);
        if (!(t < most)) continue;
        most = t;
        const glm::vec3 normal =
            glm::normalize(glm::transpose(glm::mat3(toObject)) * glm::cross(b - a, c - a));
        hit = RayCastHit{instance.entity, ray.origin + t * ray.direction,
                         glm::dot(normal, ray.direction) > 0.0f ? -normal : normal, t, false};
    }
}

}  // namespace

std::optional<RayCastHit> castRay(const SceneSnapshot& snapshot, const glm::vec3& originWorld,
                                  const glm::vec3& direction, float mostMetres,
                                  RayCastLights lights) {
    const Ray ray{originWorld, direction};
    float most = mostMetres;
    std::optional<RayCastHit> hit;
    for (const SnapshotInstance& instance : snapshot.instances)
        if (meets(ray, instance.boundsWorld, most))
            castAtInstance(snapshot, instance, ray, most, hit);
    if (lights == RayCastLights::PassedThrough) return hit;
    for (const SnapshotLight& light : snapshot.lights) {
        const float t = crossSphere(ray, light.positionWorld, light.radiusMetres);
        if (!(t < most)) continue;
        most = t;
        const glm::vec3 position = originWorld + t * direction;
        hit = RayCastHit{light.entity, position, glm::normalize(position - light.positionWorld), t,
                         true};
    }
    return hit;
}

}  // namespace lampyris::scene
