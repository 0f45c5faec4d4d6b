/// \file Host-visible memory for the small uniform structs of one frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/result.h"
#include "gpu/buffer.h"

namespace lampyris::execute {

/// Grows in blocks, powers of two in bytes, which are kept; reset() when the device is done with
/// the frame.
class UniformRing {
 public:
    struct Place {
        VkBuffer buffer = VK_NULL_HANDLE;
        uint64_t offset = 0;
        uint64_t bytes = 0;
    };
    explicit UniformRing(gpu::Device& device) : device_(&device) {}
    /// Copies the bytes in, to be bound as a uniform or as a storage buffer. An Error names the
    /// device's range of such a buffer where they are more.
    core::Result<Place> add(std::span<const uint8_t> bytes, bool storage = false);
    void reset();

 private:
    gpu::Device* device_;
    std::vector<gpu::Buffer> blocks_;
    size_t block_ = 0;
    uint64_t used_ = 0;
};

}  // namespace lampyris::execute
