#include "reference/smooth_indirect.h"

#include <array>
#include <cmath>
#include <limits>

#include "reference/parallel.h"
#include "reference/plane_fit.h"
#include "reference/warps.h"

namespace lampyris::reference {
namespace {

// Radii of the discs in pixels; each holds about twice the pixels of the last. [chosen]
constexpr std::array<float, 8> kRadii{1.5f, 2.3f, 3.3f, 4.6f, 6.5f, 9.2f, 13.0f, 18.0f};
// Half of an interval, in standard errors. [measured: see README]
constexpr double kTrust = 2.0;
constexpr float kSameNormal = 0.99f;  // cosine of 8 degrees

using Ring = std::vector<glm::ivec2>;

/// What each disc has more than the one before; the first without the centre.
std::array<Ring, kRadii.size()> makeRings() {
    std::array<Ring, kRadii.size()> rings;
    const int reach = static_cast<int>(kRadii.back());
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const float distance = std::hypot(static_cast<float>(x), static_cast<float>(y));
            for (size_t ring = 0; ring < rings.size(); ++ring) {
                if (distance > kRadii[ring]) continue;
                if (distance > 0.0f) rings[ring].emplace_back(x, y);
                break;
            }
        }
    return rings;
}

bool sameSurface(const SmoothGuide& a, const SmoothGuide& b) {
    return b.surface && a.instance == b.instance && glm::dot(a.normal, b.normal) >= kSameNormal &&
           std::abs(glm::dot(a.normal, b.position - a.position)) <= a.footprintMetres;
}

/// Where the answer lies by all estimates so far.
struct Interval {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();

    /// False where nothing is left.
    bool narrow(const PlaneFit::Estimate& estimate) {
        const double middle = (estimate.value.x + estimate.value.y + estimate.value.z) / 3.0;
        const double half = kTrust * std::sqrt(estimate.variance);
        lower = std::max(lower, middle - half);
        upper = std::min(upper, middle + half);
        return lower <= upper;
    }
};

class Smoothing {
 public:
    Smoothing(const core::Image& image, const std::vector<SmoothGuide>& guides,
              uint32_t threads)
        : image_(image), guides_(guides), threads_(threads), rings_(makeRings()), pooled_(guides.size(), 0.0) {}

    core::Image run() {
        core::Image out(image_.width, image_.height, 3);
        forEachSurface([&](int x, int y) { pooled_[index(x, y)] = pooledVariance(x, y); });
        forEachSurface([&](int x, int y) {
            const glm::vec3 value = smoothed(x, y);
            for (int c = 0; c < 3; ++c)
                out.values[3 * index(x, y) + static_cast<size_t>(c)] = std::max(value[c], 0.0f);
        });
        return out;
    }

 private:
    template <typename Visit>
    void forEachSurface(const Visit& visit) const {
        shareOut(image_.height, threads_, [&](uint32_t row) {
            const int y = static_cast<int>(row);
            for (int x = 0; x < static_cast<int>(image_.width); ++x)
                if (guides_[index(x, y)].surface) visit(x, y);
        });
    }

    /// Visits a ring's pixels on the centre's surface.
    template <typename Visit>
    void visitRing(int x, int y, size_t ring, const Visit& visit) const {
        const SmoothGuide& centre = guides_[index(x, y)];
        for (const glm::ivec2 offset : rings_[ring]) {
            const int u = x + offset.x, v = y + offset.y;
            if (u < 0 || v < 0 || u >= static_cast<int>(image_.width) ||
                v >= static_cast<int>(image_.height))
                continue;
            if (sameSurface(centre, guides_[index(u, v)])) visit(index(u, v));
        }
    }

    /// Single pixels have too few sequences to know their variance.
    [[nodiscard]] double pooledVariance(int x, int y) const {
        double sum = static_cast<double>(guides_[index(x, y)].variance);
        int count = 1;
        for (size_t ring = 0; ring < 2; ++ring)
            visitRing(x, y, ring, [&](size_t neighbour) {
                sum += static_cast<double>(guides_[neighbour].variance);
                ++count;
            });
        return sum / count;
    }

    [[nodiscard]] glm::vec3 smoothed(int x, int y) const {
        const SmoothGuide& centre = guides_[index(x, y)];
        const Frame frame(centre.normal);
        PlaneFit fit;
        fit.add(glm::dvec2(0.0), valueAt(index(x, y)), pooled_[index(x, y)]);
        PlaneFit::Estimate best = fit.atCentre();
        Interval interval;
        interval.narrow(best);
        for (size_t ring = 0; ring < rings_.size(); ++ring) {
            visitRing(x, y, ring, [&](size_t neighbour) {
                const glm::vec3 local =
                    frame.toLocal(guides_[neighbour].position - centre.position);
                fit.add(glm::dvec2(local) / static_cast<double>(centre.footprintMetres),
                        valueAt(neighbour), pooled_[neighbour]);
            });
            const PlaneFit::Estimate next = fit.atCentre();
            if (!interval.narrow(next)) break;
            best = next;
        }
        return glm::vec3(best.value);
    }

    [[nodiscard]] size_t index(int x, int y) const {
        return static_cast<size_t>(y) * image_.width + static_cast<size_t>(x);
    }
    [[nodiscard]] glm::dvec3 valueAt(size_t pixel) const {
        return {image_.values[3 * pixel], image_.values[3 * pixel + 1],
                image_.values[3 * pixel + 2]};
    }

    const core::Image& image_;
    const std::vector<SmoothGuide>& guides_;
    uint32_t threads_;
    std::array<Ring, kRadii.size()> rings_;
    std::vector<double> pooled_;
};

}  // namespace

core::Image smoothIndirect(const core::Image& irradiance, const std::vector<SmoothGuide>& guides,
                           uint32_t threads) {
    return Smoothing(irradiance, guides, threads).run();
}

}  // namespace lampyris::reference
