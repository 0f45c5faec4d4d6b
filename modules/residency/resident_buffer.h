/// \file A device buffer that outlives frames, grows, and keeps what it holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "gpu/buffer.h"
#include "gpu/staging.h"
#include "graph/frame.h"

namespace lampyris::residency {

/// The name by which modules that do not see gpu/ pass a device on.
using Device = gpu::Device;

class ResidentBuffer {
 public:
    /// reserve() keeps within what a shader can see at once. \param texelBytes of the texel view
    /// that shaders use: maxTexelBufferElements of them; 0: they bind it as a storage buffer, of
    /// maxStorageBufferRange. \param device must outlive this.
    ResidentBuffer(Device& device, std::string name, uint32_t texelBytes = 0);

    /// Makes room. Waits for the device and copies where the buffer has to grow. Errors name the
    /// limit.
    core::Result<void> reserve(uint64_t bytes);
    /// Keeps bytes for the `upload…` node of the next import(). They must lie within what was
    /// reserved.
    core::Result<void> stage(uint64_t offset, std::span<const std::byte> bytes);
    /// The same without the bytes: the caller writes them into the span, which may be slow to read,
    /// before anything else is staged.
    core::Result<std::span<std::byte>> stageRoom(uint64_t offset, uint64_t bytes);
    /// Declares the buffer, and where bytes were staged a node named `node` that brings them over.
    [[nodiscard]] graph::Buffer import(graph::Frame& frame, const std::string& node);

    [[nodiscard]] uint64_t bytes() const { return buffer_.bytes(); }

 private:
    friend class Loading;
    // Host buffers take turns, so that the device may still read the last ones: as many as frames
    // can be in flight, and one more. [chosen]
    static constexpr size_t kTurns = 3;

    struct Piece {
        uint64_t source;
        uint64_t target;
        uint64_t bytes;
    };
    core::Result<void> roomInTurn(uint64_t bytes);
    /// Sends what was staged, and waits until it has arrived.
    core::Result<void> sendStaged(gpu::Staging& staging);

    Device* device_;
    std::string name_;
    uint64_t mostBytes_;
    std::string limit_;  ///< the name of what mostBytes_ comes from
    gpu::Buffer buffer_;
    std::array<gpu::Buffer, kTurns> turns_;
    size_t turn_ = 0;
    std::vector<Piece> pieces_;
    uint64_t staged_ = 0;
};

/// Writes to resident buffers outside of frames. For what is new: it waits for the device.
class Loading {
 public:
    /// Waits until no frame reads what may be overwritten.
    static core::Result<Loading> begin(Device& device);
    /// What was staged in the target before goes first.
    core::Result<void> write(ResidentBuffer& target, uint64_t offset,
                             std::span<const std::byte> bytes);
    /// Waits until all has arrived.
    core::Result<void> finish() { return staging_.flush(); }

 private:
    explicit Loading(gpu::Staging staging) : staging_(std::move(staging)) {}
    gpu::Staging staging_;
};

}  // namespace lampyris::residency
