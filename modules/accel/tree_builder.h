/// \file Builds binary trees with Embree's SAH builder. No Embree type leaves the .cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "accel/tree.h"
#include "core/result.h"

namespace lampyris::accel {

/// Gives the box of a primitive; false leaves it out of the tree.
using BoxOf = std::function<bool(uint32_t primitive, math::Bounds& box)>;

/// Keeps Embree's device, and with it its threads.
class TreeBuilder {
 public:
    TreeBuilder();
    ~TreeBuilder();
    TreeBuilder(TreeBuilder&&) noexcept;
    TreeBuilder& operator=(TreeBuilder&&) noexcept;

    /// A tree over primitives 0 to count − 1, with leaves of up to `leafSize` (1 to 4). The tree
    /// depends on the boxes alone, not on the number of threads. Errors: out of memory.
    core::Result<Tree> build(uint32_t count, uint32_t leafSize, const BoxOf& boxOf);

 private:
    struct Device;
    std::unique_ptr<Device> device_;
};

}  // namespace lampyris::accel
