#include "evaluation/dynamic_flicker.h"

#include <algorithm>
#include <cmath>

#include "evaluation/plane.h"

namespace lampyris::evaluation {
namespace {

/// Means of luma over blocks.
Plane blocksOf(const core::DisplayImage& image) {
    const Plane luma = lumaOf(image);
    Plane sums((luma.width + kFlickerBlock - 1) / kFlickerBlock,
               (luma.height + kFlickerBlock - 1) / kFlickerBlock);
    for (size_t y = 0; y < luma.height; ++y)
        for (size_t x = 0; x < luma.width; ++x)
            sums.values[y / kFlickerBlock * sums.width + x / kFlickerBlock] +=
                luma.values[y * luma.width + x];
    for (uint32_t y = 0; y < sums.height; ++y)
        for (uint32_t x = 0; x < sums.width; ++x)
            sums.values[size_t{y} * sums.width + x] /=
                std::min(kFlickerBlock, luma.width - x * kFlickerBlock) *
                std::min(kFlickerBlock, luma.height - y * kFlickerBlock);
    return sums;
}

core::Result<void> check(std::span<const core::DisplayImage> frames,
                         std::span<const core::DisplayImage> references) {
    if (frames.size() != references.size() || frames.size() < 2)
        return core::error(
            "{} frames and {} of the reference: dynamic flicker needs as many of each, two at "
            "least",
            frames.size(), references.size());
    for (const auto& images : {frames, references})
        for (const core::DisplayImage& image : images)
            if (image.width != frames[0].width || image.height != frames[0].height ||
                image.values.empty())
                return core::error("a frame is {}x{}, the first is {}x{}", image.width,
                                   image.height, frames[0].width, frames[0].height);
    return {};
}

}  // namespace

core::Result<DynamicFlicker> dynamicFlicker(std::span<const core::DisplayImage> frames,
                                            std::span<const core::DisplayImage> references) {
    TRY_VOID(check(frames, references));
    DynamicFlicker flicker;
    Plane frameBefore = blocksOf(frames[0]);
    Plane referenceBefore = blocksOf(references[0]);
    for (size_t t = 1; t < frames.size(); ++t) {
        Plane frame = blocksOf(frames[t]);
        Plane reference = blocksOf(references[t]);
        double sum = 0.0;
        for (size_t b = 0; b < frame.values.size(); ++b)
            sum += std::abs((frame.values[b] - frameBefore.values[b]) -
                            (reference.values[b] - referenceBefore.values[b]));
        flicker.changes.push_back(sum / static_cast<double>(frame.values.size()));
        flicker.value += flicker.changes.back() / static_cast<double>(frames.size() - 1);
        frameBefore = std::move(frame);
        referenceBefore = std::move(reference);
    }
    return flicker;
}

}  // namespace lampyris::evaluation
