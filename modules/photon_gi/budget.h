/// \file A budget instead of knobs: settings that keep the cost of indirect light at so many
/// milliseconds of the device. No Vulkan: what frames cost goes in, settings come out.
///   theory  BUDGET.md [U1], [U2]
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "photon_gi/cost_curve.h"

namespace lampyris::photon_gi {

struct BudgetState {
    double wantedMilliseconds = 0.0;
    double milliseconds = 0.0;  ///< of the last frames drawn alike; 0: none yet
    double quality = 1.0;       ///< 1: all that was asked for; 0: the least there is
    bool outOfReach = false;    ///< the least costs more
    Settings asked, given;
    uint32_t changes = 0;  ///< of what was given, so far
    uint32_t begun = 0;    ///< of them, those of low resolution: the mean over frames began anew
};

/// "paths 900 instead of 2500, gather rays 2 instead of 3", in ASCII; empty where nothing was given
/// up.
[[nodiscard]] std::string whatWasGivenUp(const Settings& asked, const Settings& given);

/// Gives up, and gives back up to what was asked for. Of `full`'s final gather alone: other
/// settings it hands on as they are.
class Budget {
 public:
    explicit Budget(double milliseconds) { setMilliseconds(milliseconds); }
    /// Of the device, a frame's indirect light; what is negative or no number counts as 0.
    void setMilliseconds(double milliseconds) { wanted_ = milliseconds > 0.0 ? milliseconds : 0.0; }

    /// What the next frame is drawn with.
    [[nodiscard]] Settings next(const Settings& asked, graph::Extent size);
    /// What that frame took; nothing is learned where it drew no indirect light, or where the times
    /// are no numbers.
    void learn(const IndirectCost& cost);

    [[nodiscard]] BudgetState state() const;

 private:
    void follow(const Settings& asked, graph::Extent size);
    /// Moves where frames cost something else than is wanted.
    void steer();
    /// What its move is to cost, where settings cost `now`.
    [[nodiscard]] double targetFrom(double now) const;
    /// Whether it is another place.
    bool moveTo(const Place& place);
    /// Median factors to the model's cost of the last frames.
    [[nodiscard]] IndirectCost factorsOf(size_t frames) const;
    /// How far their cost may be off by chance, as a share of it.
    [[nodiscard]] double errorOf(size_t frames) const;

    double wanted_ = 0.0;
    Settings asked_;
    graph::Extent size_;
    std::optional<CostCurve> curve_;
    Place place_;
    std::optional<IndirectCost> known_;  ///< factors, as last believed
    std::deque<IndirectCost> factors_;   ///< a frame each, since the last move
    uint32_t toSkip_ = 0;                ///< frames that a change makes dearer than others
    uint32_t changes_ = 0, begun_ = 0;
};

}  // namespace lampyris::photon_gi
