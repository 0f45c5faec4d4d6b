#include "reference/ray_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/surface.h"

namespace lampyris::reference {
namespace {

// One thread builds: Embree's threads leave a leaf's triangles in any order, and a ray through a
// shared edge would hit now the one, now the other.
constexpr const char* kDeviceConfig = "threads=1";

// Share of the scene's largest coordinate. Float keeps 6e-8 of it; a hit point and a ray take some
// ten roundings. [chosen]
constexpr float kClearance = 3e-6f;

// Clearances from a triangle's edges at which rays start: a ray that leaves a surface at a
// clearance is then inside corners of 15 degrees and more. [chosen]
constexpr float kFromEdges = 4.0f;

/// For each of up to N rays that hit a triangle: does it stand there?
void cutOut(const RTCFilterFunctionNArguments* args) {
    const auto& placed = *static_cast<const PlacedMesh*>(args->geometryUserPtr);
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0) continue;
        const MeshPoint point(placed, RTCHitN_primID(args->hit, args->N, i),
                              RTCHitN_u(args->hit, args->N, i), RTCHitN_v(args->hit, args->N, i));
        if (!opaque(point)) args->valid[i] = 0;
    }
}

RTCRay toEmbree(const Ray& ray) {
    RTCRay to{};
    to.org_x = ray.origin.x;
    to.org_y = ray.origin.y;
    to.org_z = ray.origin.z;
    to.tnear = ray.near;
    to.dir_x = ray.direction.x;
    to.dir_y = ray.direction.y;
    to.dir_z = ray.direction.z;
    to.tfar = ray.far;
    to.mask = ~0u;
    return to;
}

RTCIntersectContext incoherent() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

}  // namespace

struct RayScene::Parts {
    Parts() : device(rtcNewDevice(kDeviceConfig)), scene(rtcNewScene(device)) {
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);  // no ray slips through an edge
    }
    ~Parts() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void attach(uint32_t id, PlacedMesh& mesh) const {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   mesh.positionsWorld.data(), 0, sizeof(glm::vec3),
                                   mesh.mesh->positions.size());
        // Embree's own copy: it may read past the end, where the mesh's indices have no room.
        void* indices =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(uint32_t), mesh.mesh->triangleCount());
        if (indices != nullptr)
            std::copy_n(mesh.mesh->indices.data(), 3 * size_t{mesh.mesh->triangleCount()},
                        static_cast<uint32_t*>(indices));
        if (mesh.material->alphaMode == assets::AlphaMode::Mask) {
            rtcSetGeometryUserData(geometry, &mesh);
            rtcSetGeometryIntersectFilterFunction(geometry, cutOut);
            rtcSetGeometryOccludedFilterFunction(geometry, cutOut);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, id);
        rtcReleaseGeometry(geometry);
    }

    RTCDevice device;
    RTCScene scene;
    scene::SceneSnapshot snapshot;
    std::vector<PlacedMesh> meshes;  ///< by instance; without a mesh where it has no place
    float clearance = 0.0f;
};

RayScene::RayScene(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

core::Result<RayScene> RayScene::build(scene::SceneSnapshot snapshot) {
    auto parts = std::make_unique<Parts>();
    parts->snapshot = std::move(snapshot);
    for (const auto& instance : parts->snapshot.instances)
        parts->meshes.push_back(place(parts->snapshot, instance).value_or(PlacedMesh{}));
    size_t triangles = 0;
    float largest = 0.0f;
    for (uint32_t i = 0; i < parts->meshes.size(); ++i) {
        PlacedMesh& mesh = parts->meshes[i];
        if (mesh.mesh == nullptr) continue;
        parts->attach(i, mesh);
        triangles += mesh.mesh->triangleCount();
        for (const glm::vec3& p : mesh.positionsWorld)
            largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    parts->clearance = kClearance * largest;
    rtcCommitScene(parts->scene);
    const RTCError failed = rtcGetDeviceError(parts->device);
    if (failed != RTC_ERROR_NONE)
        return core::error("Embree: a scene of {} triangles failed with error {}", triangles,
                           static_cast<int>(failed));
    return RayScene(std::move(parts));
}

std::optional<RayHit> RayScene::closest(const Ray& ray) const {
    RTCIntersectContext context = incoherent();
    RTCRayHit found{};
    found.ray = toEmbree(ray);
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(parts_->scene, &context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return RayHit{found.hit.geomID, found.hit.primID, found.hit.u, found.hit.v, found.ray.tfar};
}

bool RayScene::blocked(const Ray& ray) const {
    RTCIntersectContext context = incoherent();
    RTCRay asked = toEmbree(ray);
    rtcOccluded1(parts_->scene, &context, &asked);
    return asked.tfar < 0.0f;
}

MeshPoint RayScene::pointAt(const RayHit& hit) const {
    MeshPoint point(parts_->meshes[hit.instance], hit.primitive, hit.u, hit.v);
    point.keepFromEdges(kFromEdges * parts_->clearance);
    return point;
}

const scene::SceneSnapshot& RayScene::snapshot() const {
    return parts_->snapshot;
}

const PlacedMesh* RayScene::placed(uint32_t instance) const {
    const PlacedMesh& mesh = parts_->meshes[instance];
    return mesh.mesh == nullptr ? nullptr : &mesh;
}

float RayScene::clearance() const {
    return parts_->clearance;
}

}  // namespace lampyris::reference
