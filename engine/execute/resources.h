/// \file Which physical image or buffer stands behind each resource of one frame.
#pragma once

#include <vector>

#include "core/result.h"
#include "gpu/buffer.h"
#include "gpu/image.h"
#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::execute {

class Transients;
class HistoryBook;

class Resources {
 public:
    /// Errors name an imported resource that has no object, or one that is smaller than described.
    static core::Result<Resources> resolve(const graph::Frame& frame,
                                           const graph::CompiledGraph& graph,
                                           const Transients& transients,
                                           const HistoryBook& history);

    [[nodiscard]] const gpu::Buffer& buffer(uint32_t resource) const;
    [[nodiscard]] const gpu::Image& image(uint32_t resource) const;

 private:
    struct Physical {
        const gpu::Buffer* buffer = nullptr;
        const gpu::Image* image = nullptr;
    };
    static core::Result<Physical> resolveImport(const graph::ResourceInfo& info);
    std::vector<Physical> physical_;  ///< by resource; empty where no step touches it
};

}  // namespace lampyris::execute
