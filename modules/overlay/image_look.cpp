#include "overlay/image_look.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "overlay/shaders.h"

namespace lampyris::overlay {
namespace {

constexpr uint32_t kMostWidth = 960;  // [chosen] pixels; of wider images not every texel is shown
constexpr uint32_t kNowhere = 0xffffffffu;

bool isWhole(graph::Format format) {
    return format == graph::Format::R32Uint || format == graph::Format::RGBA32Uint;
}

const graph::Shader& shaderFor(const graph::ImageDesc& desc) {
    const bool layered = desc.layers > 1 || desc.array;
    if (isWhole(desc.format)) return layered ? shaders::lookUintArray : shaders::lookUint;
    return layered ? shaders::lookArray : shaders::look;
}

graph::Extent shownExtent(graph::Extent extent) {
    const uint32_t step = (extent.width + kMostWidth - 1) / kMostWidth;
    return extent.dividedBy(step);
}

/// The newest of that name, as its last writer left it.
graph::Image find(const graph::Frame& frame, const std::string& name) {
    graph::Image found;
    const auto& resources = frame.resources();
    for (uint32_t i = 0; i < resources.size(); ++i)
        if (resources[i].isImage && resources[i].name == name) {
            // What comes from outside and what history brings is complete; all else may not be
            // written in this frame.
            const bool complete =
                resources[i].origin == graph::Origin::Imported || resources[i].historyPrevious;
            if (resources[i].versions < 2 && !complete) continue;
            found = {i, resources[i].versions - 1};
        }
    return found;
}

float unordered(uint32_t bits) {
    return std::bit_cast<float>((bits & 0x80000000u) != 0 ? bits & 0x7fffffffu : ~bits);
}

}  // namespace

core::Result<ImageLook> ImageLook::create(gpu::Device& device) {
    std::array<gpu::Buffer, 2> buffers;
    for (gpu::Buffer& buffer : buffers) {
        TRY(buffer, gpu::Buffer::create(device, {.bytes = sizeof(shared::LookFindings),
                                                 .memory = gpu::MemoryUse::ReadBack,
                                                 .name = "overlay findings"}));
    }
    return ImageLook{std::move(buffers)};
}

const shared::LookFindings* ImageLook::findings() const {
    if (!written_[next_]) return nullptr;
    return reinterpret_cast<const shared::LookFindings*>(buffers_[next_].mapped().data());
}

std::array<float, 2> ImageLook::range() const {
    const shared::LookFindings* const found = findings();
    if (found == nullptr || found->leastInverted == 0) return {0.0f, 1.0f};
    return {unordered(~found->leastInverted), unordered(found->most)};
}

graph::Image ImageLook::addNode(graph::Frame& frame) {
    if (choice.name != shownName_) written_ = {};  // what is known is another image's
    shownName_ = choice.name;
    const graph::Image source = find(frame, choice.name);
    missing_ = !source.valid();
    if (missing_) {
        written_ = {};
        return {};
    }
    desc_ = frame.desc(source);
    const auto [least, most] = range();
    shared::LookParams params{};
    params.offset = choice.wholeRange ? least : 0.0f;
    params.gain =
        choice.wholeRange ? 1.0f / std::max(most - least, 1e-20f) : std::exp2(choice.exposureEv);
    params.channel = choice.channel;
    params.encode = choice.encode && !isWhole(desc_.format) ? 1 : 0;
    params.layer = std::min(choice.layer, desc_.layers - 1);
    params.cursorX = choice.cursor ? choice.cursor->x : kNowhere;
    params.cursorY = choice.cursor ? choice.cursor->y : kNowhere;
    params.channels = graph::channels(desc_.format);

    auto clear = frame.transfer("overlay/look_clear");
    graph::Buffer findings =
        clear.fill(frame.buffer("overlay findings", {sizeof(shared::LookFindings)}), 0);
    const graph::Extent extent = shownExtent(desc_.extent);
    auto look = frame.compute("overlay/look", shaderFor(desc_));
    look.sample(shared::SLOT_LOOK_SOURCE, source).push(params);
    findings = look.update(shared::SLOT_LOOK_FINDINGS, findings);
    const graph::Image shown = look.write(
        shared::SLOT_LOOK_SHOWN, frame.image("overlay look", {graph::Format::RGBA8Unorm, extent}));
    look.dispatchOver(extent);
    auto keep = frame.transfer("overlay/look_findings");
    const gpu::Buffer& host = buffers_[next_];
    const graph::Buffer kept = frame.importBuffer("overlay findings kept", {host.bytes()}, {&host},
                                                  graph::Access::HostRead);
    (void)keep.copy(findings, 0, kept, 0, sizeof(shared::LookFindings));
    written_[next_] = true;
    cursors_[next_] = choice.cursor;
    next_ = 1 - next_;
    return shown;
}

}  // namespace lampyris::overlay
