#include "accel/embree_rays.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "residency/pack_scene.h"

namespace lampyris::accel {
namespace {

// Rays a thread takes at a time: enough to forget the cost of taking them. [chosen]
constexpr size_t kChunk = 4096;

/// One instance as an Embree geometry, in world space.
RTCGeometry worldGeometry(RTCDevice device, const assets::Mesh& mesh,
                          const glm::mat4& objectToWorld) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), mesh.positions.size()));
    auto* indices = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(uint32_t), mesh.triangleCount()));
    if (positions != nullptr)
        std::transform(
            mesh.positions.begin(), mesh.positions.end(), positions,
            [&](const glm::vec3& p) { return glm::vec3(objectToWorld * glm::vec4(p, 1.0f)); });
    if (indices != nullptr) std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    rtcCommitGeometry(geometry);
    return geometry;
}

RTCRayHit toEmbree(const shared::GpuRay& ray) {
    RTCRayHit rayHit{};
    rayHit.ray.org_x = ray.originTMin.x;
    rayHit.ray.org_y = ray.originTMin.y;
    rayHit.ray.org_z = ray.originTMin.z;
    rayHit.ray.tnear = ray.originTMin.w;
    rayHit.ray.dir_x = ray.directionTMax.x;
    rayHit.ray.dir_y = ray.directionTMax.y;
    rayHit.ray.dir_z = ray.directionTMax.z;
    rayHit.ray.tfar = ray.directionTMax.w;
    rayHit.ray.mask = ~0u;
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return rayHit;
}

shared::GpuHit fromEmbree(const RTCRayHit& rayHit) {
    shared::GpuHit hit{};
    hit.tBary = glm::vec4(rayHit.ray.tfar, rayHit.hit.u, rayHit.hit.v, 0.0f);
    hit.normal = glm::vec4(rayHit.hit.Ng_x, rayHit.hit.Ng_y, rayHit.hit.Ng_z, 0.0f);
    hit.instance = rayHit.hit.geomID;
    hit.primitive = rayHit.hit.primID;
    return hit;
}

}  // namespace

struct EmbreeRays::Parts {
    Parts() : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {}
    ~Parts() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    RTCDevice device;
    RTCScene scene;
    uint64_t triangles = 0;
};

EmbreeRays::EmbreeRays(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
EmbreeRays::~EmbreeRays() = default;
EmbreeRays::EmbreeRays(EmbreeRays&&) noexcept = default;
EmbreeRays& EmbreeRays::operator=(EmbreeRays&&) noexcept = default;

core::Result<EmbreeRays> EmbreeRays::create(const scene::SceneSnapshot& snapshot) {
    auto parts = std::make_unique<Parts>();
    for (uint32_t i = 0; i < snapshot.instances.size(); ++i) {
        const auto& instance = snapshot.instances[i];
        const auto& mesh = *snapshot.meshes[instance.mesh].value;
        const auto placement = residency::placementOf(instance.objectToWorld);
        if (!placement || mesh.triangleCount() == 0) continue;
        RTCGeometry geometry = worldGeometry(parts->device, mesh, placement->objectToWorld);
        rtcAttachGeometryByID(parts->scene, geometry, i);
        rtcReleaseGeometry(geometry);
        parts->triangles += mesh.triangleCount();
    }
    rtcCommitScene(parts->scene);
    const RTCError error = rtcGetDeviceError(parts->device);
    if (error != RTC_ERROR_NONE)
        return core::error("Embree: a scene of {} triangles failed with error {}", parts->triangles,
                           static_cast<int>(error));
    return EmbreeRays(std::move(parts));
}

void EmbreeRays::trace(std::span<const shared::GpuRay> rays, std::span<shared::GpuHit> hits) const {
    std::atomic<size_t> next{0};
    const auto work = [&] {
        for (size_t begin = next.fetch_add(kChunk); begin < rays.size();
             begin = next.fetch_add(kChunk))
            for (size_t i = begin; i < std::min(begin + kChunk, rays.size()); ++i) {
                RTCIntersectContext context;
                rtcInitIntersectContext(&context);
                RTCRayHit rayHit = toEmbree(rays[i]);
                rtcIntersect1(parts_->scene, &context, &rayHit);
                hits[i] = fromEmbree(rayHit);
            }
    };
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()) - 1);
    for (std::thread& thread : threads) thread = std::thread(work);
    work();
    for (std::thread& thread : threads) thread.join();
}

uint64_t EmbreeRays::triangleCount() const {
    return parts_->triangles;
}

}  // namespace lampyris::accel
