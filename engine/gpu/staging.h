/// \file Bytes from the host into device buffers and images, and back, outside of frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/result.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/image.h"

namespace lampyris::gpu {

/// Collects writes and sends them in bulk. Waits for the device, so it belongs to loading and
/// tests; what changes every frame goes through a transfer node.
class Staging {
 public:
    static core::Result<Staging> create(Device& device);

    core::Result<void> write(const Buffer& target, uint64_t offset,
                             std::span<const std::byte> bytes);
    /// All texels of one layer, tightly packed. The layer is then ready to be sampled; what other
    /// layers hold stays.
    core::Result<void> write(const Image& target, uint32_t layer, std::span<const std::byte> bytes);
    /// Sends what was written and waits until it has arrived.
    core::Result<void> flush();
    /// Flushes, then reads.
    core::Result<std::vector<std::byte>> read(const Buffer& source, uint64_t offset,
                                              uint64_t bytes);

 private:
    struct Piece {
        const Buffer* buffer;  ///< or
        const Image* image;
        uint64_t offset;  ///< in the buffer, or the layer
        uint32_t row;     ///< image: first row
        uint32_t rows;    ///< image: their number
        uint64_t stagingOffset;
        uint64_t bytes;
    };
    explicit Staging(Device& device) : device_(&device) {}
    /// Copies as much as fits, flushing where nothing does; gives the number of bytes taken, a
    /// multiple of `unit`.
    core::Result<uint64_t> take(std::span<const std::byte> bytes, uint64_t unit);
    void record(VkCommandBuffer commands, const Piece& piece) const;

    Device* device_;
    Buffer buffer_;
    Commands commands_;
    std::vector<Piece> pieces_;
    uint64_t used_ = 0;
};

/// Whole values into a buffer, for loading: staging, flushed.
template <typename T>
core::Result<void> upload(Device& device, const Buffer& target, std::span<const T> values,
                          uint64_t offset = 0) {
    TRY(Staging staging, Staging::create(device));
    TRY_VOID(staging.write(target, offset, std::as_bytes(values)));
    return staging.flush();
}

}  // namespace lampyris::gpu
