#include "flicker/watch.h"

#include <fmt/format.h>

#include <utility>

#include "core/file.h"
#include "flicker/call.h"

namespace lampyris::sandbox::flicker {
namespace {

/// RGBA or BGRA of 8 bits, without the fourth channel.
core::DisplayImage displayOf(const execute::RawImage& raw) {
    const auto& [width, height] = raw.desc.extent;
    core::DisplayImage image{width, height, std::vector<uint8_t>(size_t{width} * height * 3)};
    const bool swapped = raw.desc.format == graph::Format::BGRA8Unorm;
    for (size_t i = 0; i < image.values.size(); ++i) {
        const size_t channel = swapped ? 2 - i % 3 : i % 3;
        image.values[i] = std::to_integer<uint8_t>(raw.bytes[i / 3 * 4 + channel]);
    }
    return image;
}

std::string lagText(const std::optional<evaluation::Lag>& lag) {
    if (!lag) return "no change was followed to its end";
    const std::string frames = lag->frames
                                   ? fmt::format("{}", *lag->frames)
                                   : fmt::format("more than {}", evaluation::kLagSettled - 1);
    return fmt::format("lag {} frames (flicker leaves {:.1f} % of the change)", frames,
                       100.0 * lag->rest);
}

}  // namespace

core::Result<void> Watched::startOver(const Shown& shown) {
    const bool sceneChanged = shown.sceneVersion != last_->sceneVersion;
    const bool sameView = shown.size == last_->size && shown.cameraToWorld == last_->cameraToWorld;
    if (shown.size != last_->size) all_ = {};
    if (still_.frames() > 1) {
        flicker_ = still_.result();
        stillFrames_ = still_.frames();
    }
    still_ = {};
    sinceChange_ = 0;
    following_.reset();
    if (!sceneChanged || !sameView) return {};
    following_.emplace();
    return following_->add(lastImage_);
}

core::Result<void> Watched::add(const Shown& shown, const core::DisplayImage& image) {
    if (last_ && shown != *last_) TRY_VOID(startOver(shown));
    TRY_VOID(all_.add(image));
    if (sinceChange_ >= kSettled) TRY_VOID(still_.add(image));
    if (following_) {
        TRY_VOID(following_->add(image));
        if (following_->complete()) {
            lag_ = following_->result();
            following_.reset();
        }
    }
    csv_ += fmt::format("{},{},{:.6g}\n", frame_++, sinceChange_++, all_.changes().back());
    last_ = shown;
    lastImage_ = image;
    return {};
}

std::string Watched::summary() const {
    const bool now = still_.frames() > 1;
    if (!now && !flicker_)
        return fmt::format("flicker: nothing was still for {} frames; {}", kSettled + 2,
                           lagText(lag_));
    const auto flicker = now ? still_.result() : *flicker_;
    return fmt::format("flicker: static {:.3f}, p99 {:.2f} over {} frames; {}", flicker.mean,
                       flicker.percentile99, now ? still_.frames() : stillFrames_, lagText(lag_));
}

core::Result<Watch> Watch::create(gpu::Device& device) {
    TRY(execute::CopyRing ring, execute::CopyRing::create(device));
    return Watch{std::move(ring)};
}

core::Result<void> Watch::take(const execute::RawImage& copy) {
    const Shown shown = shown_.front();
    shown_.pop_front();
    return watched_.add(shown, displayOf(copy));
}

core::Result<void> Watch::follow(FrameLoop& loop, const gpu::Image& image,
                                 const graph::ImageDesc& desc) {
    const scene::SceneSnapshot& snapshot = loop.snapshot();
    shown_.push_back({snapshot.lightVersion + snapshot.geometryVersion + snapshot.materialVersion,
                      loop.request.camera.cameraToWorld, desc.extent});
    TRY(const auto copy, ring_.turn(image, desc));
    if (copy) TRY_VOID(take(*copy));
    return {};
}

core::Result<void> Watch::finish(const std::filesystem::path& csv) {
    while (!shown_.empty()) {
        TRY(const auto copy, ring_.takeOldest());
        TRY_VOID(take(*copy));
    }
    return core::writeFile(csv, watched_.csv());
}

}  // namespace lampyris::sandbox::flicker
