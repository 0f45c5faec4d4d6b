#include "graph/graph/random_frame.h"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace lampyris::tests {
namespace {

class Maker {
 public:
    Maker(RandomFrame& made, uint64_t seed) : made_(made), frame_(made.frame), random_(seed) {}

    void run() {
        addResources();
        const uint32_t count = 4 + pick(18);
        for (uint32_t i = 0; i < count; ++i) addNode("node" + std::to_string(i));
        addOutputs();
        made_.shaders.match(frame_);
    }

 private:
    static constexpr graph::Extent kExtent{12, 9};
    struct ImageState {
        graph::Image handle;
        bool filled = false;
        bool writable = true;
        bool depth = false;
        bool taken = false;  ///< by the node in the making
    };
    struct BufferState {
        graph::Buffer handle;
        bool filled = false;
        bool taken = false;
    };

    uint32_t pick(uint32_t below) { return static_cast<uint32_t>(random_() % below); }
    bool chance(uint32_t percent) { return pick(100) < percent; }

    void addResources() {
        using graph::Access;
        using graph::Format;
        const graph::ImageDesc colour{Format::RGBA8Unorm, kExtent};
        for (uint32_t i = 0; i < 3 + pick(4); ++i) {
            const bool depth = chance(30);
            const graph::ImageDesc desc{depth ? Format::D32Float : Format::RGBA8Unorm, kExtent};
            images_.push_back(
                {frame_.image("image" + std::to_string(i), desc), false, true, depth});
        }
        for (uint32_t i = 0; i < 3 + pick(5); ++i) {
            const graph::BufferDesc desc{64u * (1 + pick(20))};
            buffers_.push_back({frame_.buffer("buffer" + std::to_string(i), desc)});
        }
        constexpr std::array kImageStates{Access::Sampled, Access::TransferRead,
                                          Access::StorageUpdate};
        constexpr std::array kBufferStates{Access::None, Access::StorageRead, Access::HostRead,
                                           Access::TransferWrite};
        const Access imageAs = kImageStates[pick(kImageStates.size())];
        const Access bufferAs = kBufferStates[pick(kBufferStates.size())];
        images_.push_back({frame_.importImage("importedImage", colour, {}, imageAs), true});
        buffers_.push_back({frame_.importBuffer("importedBuffer", {256}, {}, bufferAs), true});
        if (chance(60)) {
            const auto history = frame_.history("history", colour, true);
            images_.push_back({history.previous, true, false});
            images_.push_back({history.current, false});
        }
    }

    template <typename States, typename Fits>
    auto* choose(States& states, Fits fits) {
        std::vector<typename States::value_type*> fitting;
        for (auto& state : states) {
            if (!state.taken && fits(state)) fitting.push_back(&state);
        }
        auto* chosen =
            fitting.empty() ? nullptr : fitting[pick(static_cast<uint32_t>(fitting.size()))];
        if (chosen != nullptr) chosen->taken = true;
        return chosen;
    }
    ImageState* readableImage() {
        return choose(images_, [](const ImageState& s) { return s.filled; });
    }
    ImageState* writableImage(bool depth) {
        return choose(images_, [&](const ImageState& s) { return s.writable && s.depth == depth; });
    }
    BufferState* readableBuffer() {
        return choose(buffers_, [](const BufferState& s) { return s.filled; });
    }
    BufferState* anyBuffer() {
        return choose(buffers_, [](const BufferState&) { return true; });
    }

    void addNode(const std::string& name) {
        for (auto& state : images_) state.taken = false;
        for (auto& state : buffers_) state.taken = false;
        switch (pick(4)) {
            case 0:
                addRaster(name);
                break;
            case 1:
                addTransfer(name);
                break;
            default:
                addCompute(name);
        }
    }

    void addCompute(const std::string& name) {
        auto node = frame_.compute(name, made_.shaders.next());
        uint32_t slot = 0;
        for (uint32_t i = pick(4); i > 0; --i) {
            if (chance(50)) {
                if (auto* buffer = readableBuffer()) readBuffer(node, slot++, buffer->handle);
            } else if (auto* image = readableImage()) {
                const bool sampled = image->depth || chance(60);
                if (sampled) node.sample(slot++, image->handle);
                if (!sampled) node.read(slot++, image->handle);
            }
        }
        for (uint32_t i = 1 + pick(2); i > 0; --i) {
            if (chance(60)) {
                if (auto* buffer = anyBuffer()) writeInPlace(node, slot++, *buffer);
            } else if (auto* image = writableImage(false)) {
                writeInPlace(node, slot++, *image);
            }
        }
        if (chance(5)) node.keep();
    }

    void readBuffer(graph::ComputeNode& node, uint32_t slot, graph::Buffer buffer) {
        switch (pick(4)) {
            case 0:
                node.texels(slot, buffer, graph::Format::RGBA32Float);
                break;
            case 1:
                node.uniform(slot, buffer);
                break;
            case 2:
                node.dispatchIndirect(buffer);
                break;
            default:
                node.read(slot, buffer);
        }
    }

    template <typename State>
    void writeInPlace(graph::ComputeNode& node, uint32_t slot, State& state) {
        const bool update = state.filled && chance(60);
        state.handle = update ? node.update(slot, state.handle) : node.write(slot, state.handle);
        state.filled = true;
    }

    void addRaster(const std::string& name) {
        auto node = frame_.raster(name, kExtent);
        if (auto* colour = writableImage(false)) {
            const bool load = colour->filled && chance(60);
            colour->handle =
                load ? node.colour(0, colour->handle) : node.clearedColour(0, colour->handle);
            colour->filled = true;
        }
        if (auto* depth = writableImage(true)) {
            if (!depth->filled || chance(30)) {
                depth->handle = node.clearedDepth(depth->handle);
            } else if (chance(50)) {
                depth->handle = node.depth(depth->handle);
            } else {
                node.testDepth(depth->handle);
            }
            depth->filled = true;
        }
        if (auto* image = chance(60) ? readableImage() : nullptr) node.sample(3, image->handle);
        if (auto* buffer = readableBuffer()) {
            chance(50) ? node.vertices(buffer->handle) : node.read(4, buffer->handle);
        }
        node.record({&made_.shaders.next()}, [](graph::RasterCommands&) {});
    }

    void addTransfer(const std::string& name) {
        auto node = frame_.transfer(name);
        auto* target = anyBuffer();
        if (target == nullptr) return;
        if (!target->filled) target->handle = node.fill(target->handle, pick(1000));
        target->filled = true;
        auto* source = readableBuffer();
        if (source != nullptr && chance(70)) {
            const uint64_t bytes =
                std::min(frame_.desc(source->handle).bytes, frame_.desc(target->handle).bytes);
            target->handle = node.copy(source->handle, 0, target->handle, 0, bytes);
        }
        auto* from = chance(50) ? readableImage() : nullptr;
        if (from == nullptr || from->depth) return;
        if (auto* to = writableImage(false)) {
            to->handle = chance(50) ? node.copy(from->handle, to->handle)
                                    : node.blit(from->handle, to->handle);
            to->filled = true;
        }
    }

    void addOutputs() {
        for (const ImageState& image : images_) {
            if (image.filled && image.writable && chance(25)) frame_.output(image.handle);
        }
        for (const BufferState& buffer : buffers_) {
            if (buffer.filled && chance(25)) frame_.output(buffer.handle);
        }
    }

    RandomFrame& made_;
    graph::Frame& frame_;
    std::mt19937_64 random_;
    std::vector<ImageState> images_;
    std::vector<BufferState> buffers_;
};

}  // namespace

RandomFrame::RandomFrame(uint64_t seed) {
    Maker(*this, seed).run();
}

}  // namespace lampyris::tests
