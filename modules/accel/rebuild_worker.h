/// \file Builds new trees for posed meshes on a thread of its own, while frames go on.
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <stop_token>

#include "accel/blas.h"
#include "accel/refit_slots.h"
#include "scene/pose.h"

namespace lampyris::accel {

/// All that a posed mesh's tree is, links relative to itself.
struct PosedBlas {
    Blas blas;
    RefitSlots slots;
    double cost = 0.0;          ///< costOf() as built
    double milliseconds = 0.0;  ///< of posing, building and flattening
};

/// The box that a posed mesh's tree is laid over: posedBounds() and a little more, as a device
/// rounds otherwise.
[[nodiscard]] math::Bounds treeBounds(const scene::PoseExtents& mesh, const scene::Pose& pose);

/// Of Embree's MEDIUM quality, from the mesh as posed.
core::Result<PosedBlas> buildPosed(TreeBuilder& builder, const assets::Mesh& mesh,
                                   const scene::Pose& pose);

/// One rebuild after the other, in the order they were asked for.
class RebuildWorker {
 public:
    RebuildWorker();
    ~RebuildWorker();  ///< ends the one in progress first
    RebuildWorker(RebuildWorker&&) noexcept;
    RebuildWorker& operator=(RebuildWorker&&) noexcept;

    /// \param forgotten  once stopped, nobody wants the tree: a build that has not begun becomes an
    /// Error
    [[nodiscard]] std::future<core::Result<PosedBlas>> ask(std::shared_ptr<const assets::Mesh> mesh,
                                                           std::shared_ptr<const scene::Pose> pose,
                                                           std::stop_token forgotten);

 private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace lampyris::accel
