/// \file The scene on the device: buffers and texture arrays that follow a SceneSnapshot by
/// version.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/result.h"
#include "residency/scene_handles.h"
#include "scene/snapshot.h"
#include "shared/scene.h"

namespace lampyris::gpu {
class Device;
}

namespace lampyris::residency {

/// Bytes sent to the device by the last update(), by what they are.
struct UploadCounts {
    uint64_t geometryBytes = 0;
    uint64_t poseBytes = 0;  ///< rest vertices, once a mesh; joints and weights that changed
    uint64_t textureBytes = 0;
    uint64_t instanceBytes = 0;
    uint64_t materialBytes = 0;
    uint64_t lightBytes = 0;
    uint64_t emitterBytes = 0;
    [[nodiscard]] uint64_t total() const {
        return geometryBytes + poseBytes + textureBytes + instanceBytes + materialBytes +
               lightBytes + emitterBytes;
    }
};

/// Owns everything of the scene that nodes read. One update() and one import a frame.
class SceneOnGpu {
 public:
    /// \param device must outlive this.
    explicit SceneOnGpu(gpu::Device& device);
    ~SceneOnGpu();
    SceneOnGpu(SceneOnGpu&&) noexcept;
    SceneOnGpu& operator=(SceneOnGpu&&) noexcept;

    /// Follows the snapshot. New meshes and images go over at once (waits for the device);
    /// instances, materials, lights, poses and emitters that changed are kept for this frame's
    /// `upload…` nodes. Errors name the limit that the scene exceeds: texture layers, texels of a
    /// buffer, memory.
    core::Result<void> update(const scene::SceneSnapshot& snapshot);

    /// Declares the scene in a frame, with `upload…` nodes for what update() found changed, and
    /// `morph` and `skin` where poses did.
    [[nodiscard]] SceneHandles import(graph::Frame& frame);

    /// What raster nodes draw, in the order of the instances.
    [[nodiscard]] const std::vector<DrawItem>& draws() const;
    /// Deformed instances, in the order of the instances.
    [[nodiscard]] const std::vector<PosedInstance>& posed() const;
    /// The emissive instances as the device has them, in the order of SceneHandles::emitters.
    [[nodiscard]] const std::vector<shared::GpuEmitter>& emitters() const;
    [[nodiscard]] uint32_t lightCount() const;
    [[nodiscard]] const UploadCounts& lastUpload() const;
    [[nodiscard]] uint64_t deviceBytes() const;
    [[nodiscard]] gpu::Device& device() const;

 private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Same as scene.import(frame); reads as a step of the frame's storyboard.
[[nodiscard]] inline SceneHandles importScene(graph::Frame& frame, SceneOnGpu& scene) {
    return scene.import(frame);
}

}  // namespace lampyris::residency
