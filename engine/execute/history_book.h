/// \file Images carried from frame to frame, by name.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/image.h"
#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::execute {

/// Two images a name; the frame's `previous` and `current` change places after a frame that wrote
/// `current`. New images hold zeros and rest in graph::restLayout().
class HistoryBook {
 public:
    explicit HistoryBook(gpu::Device& device) : device_(&device) {}

    /// Whether a frame left something under this name, of this description: what Frame::history
    /// asks.
    [[nodiscard]] bool known(std::string_view name, const graph::ImageDesc& desc) const;
    /// Forgets what was kept: the next frame starts anew.
    void forgetAll();

    /// True where a pair must be made, or made anew: the device must be idle then.
    [[nodiscard]] bool wouldChange(const graph::Frame& frame,
                                   const graph::CompiledGraph& graph) const;
    /// Makes and clears what is missing; waits for the device where something is.
    core::Result<void> prepare(const graph::Frame& frame, const graph::CompiledGraph& graph);
    /// The image of `previous` or of `current`.
    [[nodiscard]] const gpu::Image& image(const graph::ResourceInfo& info) const;
    /// After the frame was recorded.
    void turn(const graph::Frame& frame, const graph::CompiledGraph& graph);

 private:
    struct Pair {
        graph::ImageDesc desc;
        std::array<gpu::Image, 2> images;
        uint32_t previous = 0;  ///< index of the image that holds the last frame's contents
        bool written = false;   ///< by an earlier frame
    };
    core::Result<Pair> makePair(const graph::ResourceInfo& info) const;

    gpu::Device* device_;
    std::map<std::string, Pair, std::less<>> pairs_;
};

}  // namespace lampyris::execute
