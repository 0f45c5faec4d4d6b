#include "reference/smooth_indirect.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/local_fit.h"
#include "reference/parallel.h"
#include "reference/warps.h"

namespace lampyris::reference {
namespace {

// Half of an interval, in standard errors. [measured: README]
constexpr double kTrust = 1.5;
// Discs over which neighbours agree on a size, and over which they pool their variances: a pixel's
// few sequences do not tell its own. [measured: README]
constexpr size_t kAgreeDiscs = 2;
constexpr size_t kPoolDiscs = 2;

/// Where the answer lies by all estimates so far.
struct Interval {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();

    /// False where nothing is left.
    bool narrow(const LocalFit::Estimate& estimate) {
        const double middle = (estimate.value.x + estimate.value.y + estimate.value.z) / 3.0;
        const double half = kTrust * std::sqrt(estimate.variance);
        lower = std::max(lower, middle - half);
        upper = std::min(upper, middle + half);
        return lower <= upper;
    }
};

class Smoothing {
 public:
    Smoothing(const core::Image& image, const std::vector<SmoothGuide>& guides, uint32_t threads)
        : image_(image),
          guides_(guides),
          discs_(guides, image.width),
          threads_(threads),
          variance_(guides.size(), 0.0),
          size_(guides.size(), 0.0) {}

    core::Image run() {
        core::Image out(image_.width, image_.height, 3);
        forEachSurface([&](size_t pixel) {
            variance_[pixel] = discs_.mean(pixel, kPoolDiscs, [&](size_t i) {
                return static_cast<double>(guides_[i].variance);
            });
        });
        forEachSurface([&](size_t pixel) { size_[pixel] = sizeThatAgrees(pixel); });
        forEachSurface([&](size_t pixel) {
            const double size = discs_.mean(pixel, kAgreeDiscs, [&](size_t i) { return size_[i]; });
            const glm::dvec3 value = glm::max(smoothed(pixel, size), 0.0);
            for (int c = 0; c < 3; ++c)
                out.values[3 * pixel + static_cast<size_t>(c)] = static_cast<float>(value[c]);
        });
        return out;
    }

 private:
    template <typename Visit>
    void forEachSurface(const Visit& visit) const {
        shareOut(image_.height, threads_, [&](uint32_t row) {
            const size_t first = size_t{row} * image_.width;
            for (size_t pixel = first; pixel < first + image_.width; ++pixel)
                if (guides_[pixel].surface) visit(pixel);
        });
    }

    /// Calls visit(estimate) for the pixel alone and then for each disc, until it returns false.
    template <typename Visit>
    void forEachDisc(size_t pixel, const Visit& visit) const {
        const SmoothGuide& centre = guides_[pixel];
        const Frame frame(centre.normal);
        LocalFit fit;
        const auto add = [&](size_t i) {
            const glm::vec3 local = frame.toLocal(guides_[i].position - centre.position);
            fit.add(glm::dvec2(local) / static_cast<double>(centre.footprintMetres), valueAt(i),
                    variance_[i]);
        };
        add(pixel);
        for (size_t disc = 0; visit(fit.atCentre()) && disc < kDiscRadii.size(); ++disc)
            discs_.visitRing(pixel, disc, add);
    }

    /// Of the largest disc whose estimate agrees with all before; 0 is the pixel alone.
    [[nodiscard]] double sizeThatAgrees(size_t pixel) const {
        Interval interval;
        int agreeing = -1;
        forEachDisc(pixel, [&](const LocalFit::Estimate& estimate) {
            const bool agrees = interval.narrow(estimate);
            if (agrees) ++agreeing;
            return agrees;
        });
        return std::max(agreeing, 0);
    }

    /// Between two discs, their estimates are mixed.
    [[nodiscard]] glm::dvec3 smoothed(size_t pixel, double size) const {
        glm::dvec3 value(0.0);
        double at = 0.0;
        forEachDisc(pixel, [&](const LocalFit::Estimate& estimate) {
            const double share = std::clamp(size - at + 1.0, 0.0, 1.0);
            value = glm::mix(value, estimate.value, share);
            at += 1.0;
            return at - 1.0 < size;
        });
        return value;
    }

    [[nodiscard]] glm::dvec3 valueAt(size_t pixel) const {
        return {image_.values[3 * pixel], image_.values[3 * pixel + 1],
                image_.values[3 * pixel + 2]};
    }

    const core::Image& image_;
    const std::vector<SmoothGuide>& guides_;
    SurfaceDiscs discs_;
    uint32_t threads_;
    std::vector<double> variance_;  ///< of a pixel's mean channel, pooled
    std::vector<double> size_;      ///< discs; see sizeThatAgrees
};

}  // namespace

core::Image smoothIndirect(const core::Image& irradiance, const std::vector<SmoothGuide>& guides,
                           uint32_t threads) {
    return Smoothing(irradiance, guides, threads).run();
}

}  // namespace lampyris::reference
