/// \file The physical images and buffers behind a graph's transients, sharing memory as compiled.
#pragma once

#include <optional>
#include <vector>

#include "core/result.h"
#include "gpu/buffer.h"
#include "gpu/image.h"
#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::execute {

/// Kept from frame to frame while the graph's layoutHash stays; made anew when it changes.
class Transients {
 public:
    explicit Transients(gpu::Device& device) : device_(&device) {}
    /// True where follow() will destroy what is there: the device must be idle then.
    [[nodiscard]] bool wouldChange(const graph::CompiledGraph& graph) const;
    core::Result<void> follow(const graph::Frame& frame, const graph::CompiledGraph& graph);

    /// Null for what is no touched transient.
    [[nodiscard]] const gpu::Buffer* buffer(size_t resource) const;
    [[nodiscard]] const gpu::Image* image(size_t resource) const;

 private:
    /// One of the two.
    struct Physical {
        gpu::Buffer buffer;
        gpu::Image image;
    };
    static constexpr size_t kNone = ~size_t{0};

    core::Result<void> makeHeaps(const graph::CompiledGraph& graph);
    core::Result<void> makeResource(const graph::ResourceInfo& info,
                                    const graph::CompiledResource& compiled);
    gpu::Device* device_;
    std::optional<uint64_t> layoutHash_;
    std::vector<gpu::Allocation> heaps_;  // before what lies in them, so that they go last
    std::vector<Physical> physical_;
    std::vector<size_t> places_;  ///< in `physical_`, by resource of the frame that was followed
};

}  // namespace lampyris::execute
