/// \file What indirect light costs by its settings, as measured, and the way from the settings that
/// were asked for down to the least of them: theory and figures in BUDGET.md.
#pragma once

#include <vector>

#include "graph/resource.h"
#include "photon_gi/indirect_cost.h"
#include "photon_gi/settings.h"

namespace lampyris::photon_gi {

/// Device milliseconds of the final gather's nodes in `courtyard` on lavapipe [U1]. Other scenes
/// and devices take other times; a budget measures by what factors.
[[nodiscard]] IndirectCost modelCost(const Settings& settings, graph::Extent size);

/// A place on the way down.
struct Place {
    size_t level = 0;    ///< steps in which rays a texel, then low resolution, were given up
    double share = 1.0;  ///< between steps: 1, all paths and the radius asked for; 0, the fewest
    bool operator==(const Place&) const = default;
};

class CostCurve {
 public:
    CostCurve(const Settings& asked, graph::Extent size);
    /// By what the model's parts are to be multiplied here.
    void setFactors(const IndirectCost& factors) { factors_ = factors; }

    [[nodiscard]] Settings settingsAt(const Place& place) const;
    [[nodiscard]] double costAt(const Place& place) const;
    /// Where a cost is met, or where it is come nearest to. A step down is taken only where a good
    /// share of the paths was given up, and back up only where all were given back: a cost that
    /// wavers changes paths alone, which the mean over frames does not mind.
    [[nodiscard]] Place find(double cost, const Place& from) const;
    /// The cost beyond which find() takes the step to a level back, from all its paths. Level 0 has
    /// none.
    [[nodiscard]] double costOfStepBack(size_t level) const;
    /// The last place that is worth going to: a coarser resolution may cost more than it saves.
    [[nodiscard]] Place least() const;
    [[nodiscard]] bool isLeast(const Place& place) const;
    /// 1 as asked, 0 the least: how far down a cost is, by its logarithm.
    [[nodiscard]] double quality(const Place& place) const;

    /// The share at which a step down is taken.
    static constexpr double kStepShare = 0.5;

 private:
    struct Step {
        uint32_t gatherDivisor, gatherRays;
    };
    [[nodiscard]] double shareFor(size_t level, double cost) const;
    /// Whether there is a next step, and it saves something.
    [[nodiscard]] bool pays(size_t level) const;

    Settings asked_;
    graph::Extent size_;
    IndirectCost factors_{1.0, 1.0, 1.0};
    std::vector<Step> steps_;
};

}  // namespace lampyris::photon_gi
