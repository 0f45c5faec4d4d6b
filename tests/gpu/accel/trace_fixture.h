/// \file Rays through a scene on the device and through a loop over all of its triangles.
#pragma once

#include <cmath>
#include <optional>

#include "accel/trace_rays.h"
#include "execute/executor.h"
#include "residency/pack_scene.h"
#include "residency/resident_buffer.h"
#include "support/gpu_test.h"
#include "support/snapshot_builder.h"

namespace lampyris::test {

using shared::GpuHit;
using shared::GpuRay;

inline GpuRay ray(const glm::vec3& origin, const glm::vec3& direction, float tMin = 0.0f,
                  float tMax = 1e30f) {
    return {glm::vec4(origin, tMin), glm::vec4(direction, tMax)};
}

/// A hit in double precision, found without any tree.
struct ExactHit {
    uint32_t instance = shared::SCENE_NONE;
    uint32_t primitive = shared::SCENE_NONE;
    double t = 0.0;
    double margin = 0.0;  ///< least barycentric weight: how far from the triangle's border
    glm::dvec3 normal{0.0};
};

inline std::optional<ExactHit> crossExactly(const GpuRay& ray, const glm::dvec3& v0,
                                            const glm::dvec3& v1, const glm::dvec3& v2) {
    const glm::dvec3 origin(ray.originTMin), direction(ray.directionTMax);
    const glm::dvec3 e1 = v1 - v0, e2 = v2 - v0, normal = glm::cross(e1, e2);
    const double along = glm::dot(normal, direction);
    if (along == 0.0) return std::nullopt;
    const glm::dvec3 from = origin - v0, across = glm::cross(from, direction);
    const double u = -glm::dot(e2, across) / along, v = glm::dot(e1, across) / along;
    const double t = -glm::dot(normal, from) / along;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || t <= ray.originTMin.w || t > ray.directionTMax.w)
        return std::nullopt;
    return ExactHit{0, 0, t, std::min({u, v, 1.0 - u - v}), normal};
}

/// The nearest of all hits; at equal distance the first, so the lower (instance, primitive).
inline ExactHit nearestHit(const scene::SceneSnapshot& snapshot, const GpuRay& ray) {
    ExactHit nearest;
    nearest.t = std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < snapshot.instances.size(); ++i) {
        const auto placement = residency::placementOf(snapshot.instances[i].objectToWorld);
        if (!placement) continue;
        const glm::dmat4 matrix(placement->objectToWorld);
        const auto& mesh = *snapshot.meshes[snapshot.instances[i].mesh].value;
        const auto world = [&](size_t corner) {
            return glm::dvec3(matrix * glm::dvec4(mesh.positions[mesh.indices[corner]], 1.0));
        };
        for (uint32_t k = 0; k < mesh.triangleCount(); ++k) {
            const auto hit = crossExactly(ray, world(3 * k), world(3 * k + 1), world(3 * k + 2));
            if (!hit || hit->t >= nearest.t) continue;
            nearest = *hit;
            nearest.instance = i;
            nearest.primitive = k;
            if (placement->mirrored) nearest.normal = -nearest.normal;  // to the front side
        }
    }
    return nearest;
}

/// Rays from a box of half the given size in all directions.
inline std::vector<GpuRay> randomRays(uint32_t count, float size, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto point = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
    std::vector<GpuRay> rays;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 origin = size * point();
        rays.push_back(ray(origin, point() + glm::vec3(1e-3f)));
    }
    return rays;
}

class TraceTest : public GpuTest {
 protected:
    /// Closest hits, with surfaces and occlusion.
    std::vector<GpuHit> trace(const scene::SceneSnapshot& snapshot,
                              const std::vector<GpuRay>& rays) {
        residency::SceneOnGpu scene(device());
        accel::AccelOnGpu accel(scene);
        return traceIn(scene, accel, snapshot, rays);
    }

    std::vector<GpuHit> traceIn(residency::SceneOnGpu& scene, accel::AccelOnGpu& accel,
                                const scene::SceneSnapshot& snapshot,
                                const std::vector<GpuRay>& rays) {
        static execute::Executor executor = need(execute::Executor::create(device()));
        need(scene.update(snapshot));
        need(accel.update(snapshot));
        residency::ResidentBuffer rayBuffer(device(), "test rays", sizeof(glm::vec4));
        need(rayBuffer.reserve(rays.size() * sizeof(GpuRay)));
        need(rayBuffer.stage(0, std::as_bytes(std::span(rays))));
        graph::Frame frame;
        const auto sceneHandles = importScene(frame, scene);
        const auto accelHandles = importAccel(frame, accel, sceneHandles);
        const auto hits = accel::addTraceRays(frame, accelHandles, sceneHandles,
                                              rayBuffer.import(frame, "upload rays"),
                                              {.rayCount = static_cast<uint32_t>(rays.size()),
                                               .withSurface = true,
                                               .withOcclusion = true});
        frame.output(hits);
        execute::RunOptions options;
        options.timed = false;
        options.readBackBuffers = {hits};
        const auto result = need(executor.run(frame, options));
        return valuesOf<GpuHit>(result.buffers[0]);
    }

    /// Every hit is the loop's, save where a ray passes a border by less than rounding. \return
    /// hits found.
    static size_t expectExact(const scene::SceneSnapshot& snapshot, const std::vector<GpuRay>& rays,
                              const std::vector<GpuHit>& hits) {
        size_t found = 0, doubtful = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const ExactHit exact = nearestHit(snapshot, rays[i]);
            const GpuHit& hit = hits[i];
            const bool missed = exact.instance == shared::SCENE_NONE;
            const bool same = hit.instance == exact.instance && hit.primitive == exact.primitive;
            if (!same || (hit.occluded != 0) == missed) {
                ++doubtful;
                const bool border = exact.margin < 1e-5;
                const bool near =
                    !missed && std::abs(hit.tBary.x - exact.t) < 1e-4 * (1.0 + exact.t);
                EXPECT_TRUE(missed || border || near)
                    << "ray " << i << ": " << hit.instance << "/" << hit.primitive << " at "
                    << hit.tBary.x << ", exactly " << exact.instance << "/" << exact.primitive
                    << " at " << exact.t;
                continue;
            }
            if (missed) continue;
            ++found;
            EXPECT_NEAR(hit.tBary.x, exact.t, 2e-5 * (1.0 + exact.t)) << "ray " << i;
            const double cosine = glm::dot(glm::normalize(exact.normal), glm::dvec3(hit.normal));
            EXPECT_NEAR(cosine, 1.0, 1e-4) << "ray " << i;
        }
        EXPECT_LE(doubtful, rays.size() / 500);
        return found;
    }
};

}  // namespace lampyris::test
