#include "photon_gi/path_keeper.h"

#include <algorithm>

namespace lampyris::photon_gi {
namespace {

// [chosen] Paths that nothing touched are drawn anew in every eighth frame: the mean over frames
// goes on getting better, and what is seen changes little from one to the next.
constexpr uint32_t kTurns = 8;
// [chosen] Frames until the paths are shared out anew among the lights, by what was learned.
constexpr uint32_t kMostAge = 32;

/// A word a range, 1 where its light is not as it was.
std::vector<uint32_t> changedRanges(const photons::PathSplit& split,
                                    const std::vector<scene::SnapshotLight>& before,
                                    const std::vector<scene::SnapshotLight>& after) {
    std::vector<uint32_t> changed(split.ranges.size(), 0);
    for (size_t i = 0; i < split.ranges.size(); ++i) {
        const shared::PathRange& range = split.ranges[i];
        if (range.kind == shared::EMIT_SURFACE) continue;  // its paths begin in the changed box
        if (before[range.index].version != after[range.index].version) changed[i] = 1;
    }
    return changed;
}

}  // namespace

bool PathKeeper::goesOn(const Settings& settings, const Now& now, photons::PathChoice& choice) {
    const bool still = now.changes.none();
    if (!valid_ || !pathsGoOn(settings_, settings) || now.changes.everything) return false;
    if (now.changes.lightsCameOrWent || now.changes.instancesCameOrWent) return false;
    if (lights_.size() != now.lights.size()) return false;
    if (settings.reseed && (still || age_ >= kMostAge)) return false;
    if (!photons::repower(split_, now.emitters)) return false;
    choice.all = false;
    choice.rangesAgain = changedRanges(split_, lights_, now.lights);
    for (const scene::ChangedRegion& region : now.changes.regions)
        choice.boxes.push_back(region.boundsWorld);
    choice.turns = settings.reseed ? kTurns : 0;
    choice.turn = static_cast<uint32_t>(now.frameNumber % kTurns);
    return true;
}

uint32_t PathKeeper::turnOf(const Settings& settings, const Now& now) {
    if (!settings.reseed) return 0;
    if (age_ == 0) drawnIn_ = static_cast<uint32_t>(now.frameNumber);
    // The frames of a round share a turn: between them they draw a whole stretch of the sequence.
    return drawnIn_ + (age_ + kTurns - 1) / kTurns;
}

core::Result<PathPlan> PathKeeper::plan(const Settings& settings, const Now& now,
                                        const std::function<photons::PathSplit()>& newSplit) {
    PathPlan plan;
    if (!keepsUnchanged(settings)) {
        valid_ = false;
        age_ = 0;
        plan.split = newSplit();
        plan.turn = turnOf(settings, now);
        return plan;
    }
    if (goesOn(settings, now, plan.choice)) {
        ++age_;
    } else {
        split_ = newSplit();
        age_ = 0;
    }
    plan.split = split_;
    plan.turn = turnOf(settings, now);
    plan.kept = split_.paths > 0 && settings.maxBounces > 0 &&
                split_.paths <= settings.largestBatch &&
                photons::fitsStore(split_.paths, settings.maxBounces);
    if (plan.kept)
        TRY_VOID(store_.reserve(split_.paths,
                                photons::photonsPerPath(split_, settings.maxBounces, true),
                                settings.maxBounces));
    valid_ = plan.kept;
    settings_ = settings;
    lights_ = now.lights;
    return plan;
}

}  // namespace lampyris::photon_gi
