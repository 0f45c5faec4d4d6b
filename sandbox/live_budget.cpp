#include "live_budget.h"

#include "photon_gi/indirect_cost.h"

namespace lampyris::sandbox {

core::Result<void> checkBudget(const Options& options, std::optional<double> milliseconds) {
    if (!milliseconds) return {};
    const photon_gi::Settings asked = settingsOf(options);
    if (!photon_gi::finalGathers(asked))
        return core::error("--budget-ms is of full's final gather");
    if (asked.maxBounces == 0)
        return core::error("--budget-ms is of indirect light; --max-bounces 0 has none");
    return {};
}

LiveBudget::LiveBudget(const photon_gi::Settings& wanted, std::optional<double> milliseconds)
    : asked(wanted) {
    setMilliseconds(milliseconds);
}

void LiveBudget::setMilliseconds(std::optional<double> milliseconds) {
    if (!milliseconds)
        budget_.reset();
    else if (budget_)
        budget_->setMilliseconds(*milliseconds);
    else
        budget_.emplace(*milliseconds);
}

void LiveBudget::choose(FrameLoop& loop) {
    loop.request.settings = budget_ ? budget_->next(asked, loop.request.size) : asked;
}

void LiveBudget::learn(const LoopFrame& frame) {
    if (budget_ && frame.outcome.report.valid)
        budget_->learn(photon_gi::indirectCost(frame.outcome.statistics));
}

std::optional<photon_gi::BudgetState> LiveBudget::state() const {
    return budget_ ? std::optional{budget_->state()} : std::nullopt;
}

std::string LiveBudget::text() const {
    if (!budget_) return {};
    const photon_gi::BudgetState now = budget_->state();
    std::string text = fmt::format(", indirect light {:.1f} of {:.1f} ms", now.milliseconds,
                                   now.wantedMilliseconds);
    const std::string up = photon_gi::whatWasGivenUp(now.asked, now.given);
    if (!up.empty()) text += ", " + up;
    if (now.outOfReach) text += ": out of reach";
    return text;
}

}  // namespace lampyris::sandbox
