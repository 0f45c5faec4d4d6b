#include "accel/ray_bench.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <random>

#include "accel/embree_rays.h"
#include "accel/trace_rays.h"
#include "residency/resident_buffer.h"

namespace lampyris::accel {
namespace {

using shared::GpuHit;
using shared::GpuRay;
using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

glm::vec3 onSphere(std::mt19937& random) {
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const float z = 2.0f * uniform(random) - 1.0f;
    const float phi = 2.0f * math::kPi * uniform(random);
    const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// The diffuse bounce off a hit, from the side the ray came from.
GpuRay bounced(const GpuRay& ray, const GpuHit& hit, float reach, std::mt19937& random) {
    const glm::vec3 direction(ray.directionTMax);
    glm::vec3 normal = glm::normalize(glm::vec3(hit.normal));
    if (glm::dot(normal, direction) > 0.0f) normal = -normal;
    const glm::vec3 at =
        glm::vec3(ray.originTMin) + hit.tBary.x * direction + 1e-4f * reach * normal;
    // A point of the sphere that touches the surface, seen from there, is distributed by cosine.
    const glm::vec3 towards = normal + 0.9999f * onSphere(random);
    return {glm::vec4(at, 0.0f), glm::vec4(glm::normalize(towards), 1e30f)};
}

/// Rays of each bounce in the order of their paths.
std::vector<GpuRay> bounceRays(const EmbreeRays& embree, const math::Bounds& bounds,
                               const RayBenchSettings& settings) {
    std::mt19937 random(settings.seed);
    const glm::vec3 extent = bounds.extent();
    const float reach = std::max({extent.x, extent.y, extent.z});
    // A little off the middle, where something often stands.
    const glm::vec3 middle = bounds.centre() + glm::vec3(0.02f, 0.33f, 0.03f) * extent;
    std::vector<GpuRay> rays(settings.paths), all;
    for (GpuRay& ray : rays) ray = {glm::vec4(middle, 0.0f), glm::vec4(onSphere(random), 1e30f)};
    for (uint32_t bounce = 0; bounce < settings.bounces; ++bounce) {
        std::vector<GpuHit> hits(rays.size());
        embree.trace(rays, hits);
        std::vector<GpuRay> next;
        for (size_t i = 0; i < rays.size(); ++i)
            if (hits[i].instance != shared::SCENE_NONE)
                next.push_back(bounced(rays[i], hits[i], reach, random));
        rays = std::move(next);
        all.insert(all.end(), rays.begin(), rays.end());
    }
    return all;
}

bool sameHit(const GpuHit& a, const GpuHit& b) {
    if ((a.instance == shared::SCENE_NONE) != (b.instance == shared::SCENE_NONE)) return false;
    return a.instance == shared::SCENE_NONE ||
           std::abs(a.tBary.x - b.tBary.x) <= 1e-3f * std::max(1.0f, b.tBary.x);
}

/// The traversal on the device, ready to run again and again.
class GpuRays {
 public:
    explicit GpuRays(execute::Executor& executor)
        : executor_(&executor),
          scene_(executor.device()),
          accel_(scene_),
          rays_(executor.device(), "bench rays", sizeof(glm::vec4)) {}

    core::Result<void> load(const scene::SceneSnapshot& snapshot, std::span<const GpuRay> rays) {
        TRY_VOID(scene_.update(snapshot));
        TRY_VOID(accel_.update(snapshot));
        count_ = static_cast<uint32_t>(rays.size());
        TRY_VOID(rays_.reserve(std::max<size_t>(rays.size_bytes(), sizeof(GpuRay))));
        return rays_.stage(0, std::as_bytes(rays));
    }

    /// \return seconds on the device.
    core::Result<double> trace(std::vector<GpuHit>* hits) {
        graph::Frame frame;
        const auto scene = scene_.import(frame);
        const auto accel = accel_.import(frame, scene);
        const auto rays = rays_.import(frame, "upload rays");
        const auto result = addTraceRays(frame, accel, scene, rays, {.rayCount = count_});
        frame.output(result);
        execute::RunOptions options;
        if (hits != nullptr) options.readBackBuffers = {result};
        TRY(const execute::FrameResult done, executor_->run(frame, options));
        if (hits != nullptr) {
            hits->resize(count_);
            std::memcpy(hits->data(), done.buffers[0].data(), count_ * sizeof(GpuHit));
        }
        for (const auto& node : done.statistics.nodes)
            if (node.name == "trace_rays") return node.gpuMilliseconds * 1e-3;
        return core::error("the frame has no node trace_rays");
    }

 private:
    execute::Executor* executor_;
    residency::SceneOnGpu scene_;
    AccelOnGpu accel_;
    residency::ResidentBuffer rays_;
    uint32_t count_ = 0;
};

}  // namespace

core::Result<RayRates> measureRays(execute::Executor& executor,
                                   const scene::SceneSnapshot& snapshot,
                                   const RayBenchSettings& settings) {
    TRY(const EmbreeRays embree, EmbreeRays::create(snapshot));
    const auto rays = bounceRays(embree, snapshot.boundsWorld, settings);
    GpuRays gpu(executor);
    TRY_VOID(gpu.load(snapshot, rays));
    std::vector<GpuHit> onGpu, onCpu(rays.size());
    TRY(const double warmUp, gpu.trace(&onGpu));
    static_cast<void>(warmUp);
    std::vector<double> gpuSeconds, embreeSeconds;
    for (uint32_t i = 0; i < settings.repeats; ++i) {
        TRY(const double seconds, gpu.trace(nullptr));
        gpuSeconds.push_back(seconds);
        const auto start = Clock::now();
        embree.trace(rays, onCpu);
        embreeSeconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
    RayRates rates;
    rates.triangles = embree.triangleCount();
    rates.rays = rays.size();
    for (size_t i = 0; i < rays.size(); ++i) rates.different += sameHit(onGpu[i], onCpu[i]) ? 0 : 1;
    rates.gpuMraysPerSecond = 1e-6 * static_cast<double>(rays.size()) / median(gpuSeconds);
    rates.embreeMraysPerSecond = 1e-6 * static_cast<double>(rays.size()) / median(embreeSeconds);
    return rates;
}

}  // namespace lampyris::accel
