/// \file All trees on the device: their nodes, their triangles, and the order in which the device
/// refits them.
#pragma once

#include "accel/blas.h"
#include "residency/range_allocator.h"
#include "residency/resident_buffer.h"

namespace lampyris::accel {

/// What one tree takes, in elements.
struct TreeRange {
    uint64_t firstNode = 0, nodes = 0;
    uint64_t firstTriangle = 0, triangles = 0;
    uint64_t firstSlot = 0, slots = 0;  ///< RefitSlots; none where it is never refitted there
};

class TreeStore {
 public:
    explicit TreeStore(residency::Device& device);

    [[nodiscard]] TreeRange take(uint64_t nodes, uint64_t triangles, uint64_t slots);
    void give(const TreeRange& range);
    /// Room for all that was taken. Waits for the device where a buffer has to grow.
    core::Result<void> reserve();

    [[nodiscard]] uint64_t triangleCount() const { return triangleRanges_.used(); }
    [[nodiscard]] uint64_t bytes() const;
    /// Of the larger one of nodes and triangles.
    [[nodiscard]] uint64_t largestBytes() const;
    [[nodiscard]] residency::Device& device() const { return *device_; }

    residency::ResidentBuffer nodes, triangles, slots;

 private:
    residency::Device* device_;
    residency::RangeAllocator nodeRanges_, triangleRanges_, slotRanges_;
};

/// Gives the tree's links their place on the device.
void relocate(Tree& tree, const TreeRange& range);

}  // namespace lampyris::accel
