/// \file Copies of images for the host that are read two frames later, so that no frame waits.
#pragma once

#include <optional>
#include <vector>

#include "core/result.h"
#include "execute/raw_image.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/image.h"

namespace lampyris::execute {

class CopyRing {
 public:
    /// The device must outlive the ring.
    static core::Result<CopyRing> create(gpu::Device& device);
    CopyRing(CopyRing&&) noexcept = default;
    CopyRing& operator=(CopyRing&&) = delete;
    ~CopyRing();

    /// Submits a copy of an image that rests as Executor::outputImage() leaves it, behind all that
    /// was submitted so far, and gives the copy of the call before the last, if there was one. The
    /// image must outlive its copy.
    core::Result<std::optional<RawImage>> turn(const gpu::Image& image,
                                               const graph::ImageDesc& desc);
    /// The oldest copy that turn() has not given yet; none when all are given.
    core::Result<std::optional<RawImage>> takeOldest();

 private:
    struct Slot {
        gpu::Commands commands;
        gpu::Fence fence;
        gpu::Buffer buffer;
        graph::ImageDesc desc;
        bool pending = false;
    };
    explicit CopyRing(gpu::Device& device) : device_(&device) {}
    core::Result<RawImage> read(Slot& slot);

    gpu::Device* device_;
    std::vector<Slot> slots_;
    size_t next_ = 0;  ///< the slot of the next copy; the one after it is the oldest
};

}  // namespace lampyris::execute
