#include "accel/embree_refit.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <chrono>

#include "core/check.h"

namespace lampyris::accel {

struct EmbreeRefit::Parts {
    Parts() : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {}
    ~Parts() {
        if (geometry != nullptr) rtcReleaseGeometry(geometry);
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    RTCDevice device;
    RTCScene scene;
    RTCGeometry geometry = nullptr;
    glm::vec3* positions = nullptr;
    size_t count = 0;
};

EmbreeRefit::EmbreeRefit(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
EmbreeRefit::~EmbreeRefit() = default;
EmbreeRefit::EmbreeRefit(EmbreeRefit&&) noexcept = default;
EmbreeRefit& EmbreeRefit::operator=(EmbreeRefit&&) noexcept = default;

core::Result<EmbreeRefit> EmbreeRefit::create(const std::vector<glm::vec3>& positions,
                                              const std::vector<uint32_t>& indices) {
    auto parts = std::make_unique<Parts>();
    if (parts->device == nullptr)
        return core::error("Embree: no device ({})", rtcGetDeviceError(nullptr));
    rtcSetSceneFlags(parts->scene, RTC_SCENE_FLAG_DYNAMIC);
    parts->geometry = rtcNewGeometry(parts->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(parts->geometry, RTC_BUILD_QUALITY_REFIT);
    parts->count = positions.size();
    parts->positions = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(parts->geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), positions.size()));
    auto* corners = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(parts->geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(uint32_t), indices.size() / 3));
    if (parts->positions == nullptr || corners == nullptr)
        return core::error("Embree: {} triangles: error {}", indices.size() / 3,
                           rtcGetDeviceError(parts->device));
    std::copy(positions.begin(), positions.end(), parts->positions);
    std::copy(indices.begin(), indices.end(), corners);
    rtcCommitGeometry(parts->geometry);
    rtcAttachGeometry(parts->scene, parts->geometry);
    rtcCommitScene(parts->scene);
    return EmbreeRefit(std::move(parts));
}

double EmbreeRefit::refit(const std::vector<glm::vec3>& positions) {
    using Clock = std::chrono::steady_clock;
    CHECK(positions.size() == parts_->count);
    std::copy(positions.begin(), positions.end(), parts_->positions);
    const auto start = Clock::now();
    rtcUpdateGeometryBuffer(parts_->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(parts_->geometry);
    rtcCommitScene(parts_->scene);
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace lampyris::accel
