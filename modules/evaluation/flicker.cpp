#include "evaluation/flicker.h"

#include <algorithm>
#include <cmath>

namespace lampyris::evaluation {
namespace {

constexpr uint32_t kBlock = 8;
constexpr double kArrived = 0.1;  // of the first difference

core::Error otherSize(const core::DisplayImage& picture, uint32_t width, uint32_t height) {
    return core::error("a picture of {}x{} in a sequence of {}x{}", picture.width, picture.height,
                       width, height);
}

core::Result<void> checkSizes(std::span<const core::DisplayImage> pictures, uint32_t width,
                              uint32_t height) {
    for (const core::DisplayImage& picture : pictures)
        if (picture.width != width || picture.height != height)
            return otherSize(picture, width, height);
    return {};
}

/// Means over blocks; those at the right and lower border may be smaller.
Plane blocksOf(const core::DisplayImage& picture) {
    const Plane luma = lumaOf(picture);
    Plane blocks((luma.width + kBlock - 1) / kBlock, (luma.height + kBlock - 1) / kBlock);
    std::vector<double> counts(blocks.values.size(), 0.0);
    for (uint32_t y = 0; y < luma.height; ++y)
        for (uint32_t x = 0; x < luma.width; ++x) {
            const size_t block = size_t{y / kBlock} * blocks.width + x / kBlock;
            blocks.values[block] += luma.values[size_t{y} * luma.width + x];
            counts[block] += 1.0;
        }
    for (size_t i = 0; i < counts.size(); ++i) blocks.values[i] /= counts[i];
    return blocks;
}

std::vector<Plane> allBlocks(std::span<const core::DisplayImage> pictures) {
    std::vector<Plane> blocks;
    blocks.reserve(pictures.size());
    for (const core::DisplayImage& picture : pictures) blocks.push_back(blocksOf(picture));
    return blocks;
}

double meanDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(std::max<size_t>(a.size(), 1));
}

}  // namespace

core::Result<void> StillSequence::add(const core::DisplayImage& picture) {
    if (frames_ == 0) {
        width_ = picture.width;
        height_ = picture.height;
        const size_t pixels = size_t{width_} * height_;
        mean_.assign(pixels, 0.0);
        squares_.assign(pixels, 0.0);
        sums_.assign(3 * pixels, 0);
    }
    if (picture.width != width_ || picture.height != height_)
        return otherSize(picture, width_, height_);
    ++frames_;
    const Plane luma = lumaOf(picture);
    for (size_t i = 0; i < luma.values.size(); ++i) {
        const double off = luma.values[i] - mean_[i];
        mean_[i] += off / frames_;
        squares_[i] += off * (luma.values[i] - mean_[i]);
    }
    for (size_t i = 0; i < picture.values.size(); ++i) sums_[i] += picture.values[i];
    return {};
}

core::Result<StaticFlicker> StillSequence::flicker() const {
    if (frames_ < 2)
        return core::error("flicker needs two pictures at least; there are {}", frames_);
    StaticFlicker result;
    result.map = core::Image(width_, height_, 1);
    std::vector<double> deviations(squares_.size());
    for (size_t i = 0; i < squares_.size(); ++i) {
        deviations[i] = std::sqrt(std::max(squares_[i], 0.0) / frames_);
        result.mean += deviations[i] / static_cast<double>(squares_.size());
        result.map.values[i] = static_cast<float>(deviations[i]);
    }
    const size_t at = (deviations.size() * 99) / 100;
    if (!deviations.empty()) {
        const auto place =
            deviations.begin() + static_cast<ptrdiff_t>(std::min(at, deviations.size() - 1));
        std::nth_element(deviations.begin(), place, deviations.end());
        result.percentile99 = *place;
    }
    result.average = {width_, height_, std::vector<uint8_t>(sums_.size())};
    for (size_t i = 0; i < sums_.size(); ++i)
        result.average.values[i] = static_cast<uint8_t>((sums_[i] + frames_ / 2) / frames_);
    return result;
}

core::Result<FrameFigures> dynamicFlicker(std::span<const core::DisplayImage> pictures,
                                          std::span<const core::DisplayImage> references) {
    if (pictures.size() < 2 || pictures.size() != references.size())
        return core::error("flicker of what moves: {} pictures and {} references", pictures.size(),
                           references.size());
    TRY_VOID(checkSizes(pictures, pictures[0].width, pictures[0].height));
    TRY_VOID(checkSizes(references, pictures[0].width, pictures[0].height));
    const std::vector<Plane> i = allBlocks(pictures), r = allBlocks(references);
    FrameFigures figures;
    for (size_t t = 1; t < i.size(); ++t) {
        double sum = 0.0;
        for (size_t b = 0; b < i[t].values.size(); ++b)
            sum += std::abs((i[t].values[b] - i[t - 1].values[b]) -
                            (r[t].values[b] - r[t - 1].values[b]));
        figures.frames.push_back(sum / static_cast<double>(i[t].values.size()));
        figures.mean += figures.frames.back();
    }
    figures.mean /= static_cast<double>(figures.frames.size());
    return figures;
}

core::Result<Lag> lagOf(std::span<const core::DisplayImage> pictures) {
    if (pictures.size() <= kLastSettled)
        return core::error("lag needs a picture before the change and {} after it; there are {}",
                           kLastSettled, pictures.size());
    TRY_VOID(checkSizes(pictures, pictures[0].width, pictures[0].height));
    std::vector<double> average(size_t{pictures[0].width} * pictures[0].height, 0.0);
    for (uint32_t t = kFirstSettled; t <= kLastSettled; ++t) {
        const Plane luma = lumaOf(pictures[t]);
        for (size_t i = 0; i < average.size(); ++i)
            average[i] += luma.values[i] / (kLastSettled - kFirstSettled + 1);
    }
    Lag lag;
    for (const core::DisplayImage& picture : pictures)
        lag.differences.push_back(meanDifference(lumaOf(picture).values, average));
    for (uint32_t t = 1; t < lag.differences.size() && !lag.arrives; ++t) {
        lag.arrives = lag.differences[t] <= kArrived * lag.differences[0];
        lag.frames = t;
    }
    return lag;
}

}  // namespace lampyris::evaluation
