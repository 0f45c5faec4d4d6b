// `lampyris bench budget`: whether a budget is kept while the load steps up and down. Milliseconds
// are scaled by a fixed load, drawn turn by turn with the frames: what slows the machine down slows
// both.
#include <fmt/format.h>

#include <cmath>
#include <deque>

#include "bench.h"
#include "camera_choice.h"
#include "core/file.h"
#include "courtyard/courtyard.h"
#include "photon_gi/budget.h"
#include "photon_gi/indirect_cost.h"
#include "progress.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

constexpr double kMostOff = 0.1;
constexpr double kTimestep = 1.0 / 60.0;  // seconds
constexpr size_t kLoadFrames = 3;         // [chosen] the machine's speed is a median over these
constexpr uint32_t kFirstFrames = 20;     // whose fixed load is what others are scaled to

/// What the frames are drawn with. Of the camera the budget is not told.
struct Load {
    graph::Extent size;
    std::string camera;
};

struct Cost {
    photon_gi::IndirectCost raw;     ///< device milliseconds
    photon_gi::IndirectCost scaled;  ///< what they would be on the machine as it was at first
    double fixedLoad;                ///< device milliseconds
};

/// A frame's indirect light, drawn until it is whole.
core::Result<photon_gi::IndirectCost> drawOnce(FrameLoop& loop, uint64_t number) {
    TRY(const LoopFrame frame, loop.draw(number));
    return photon_gi::indirectCost(frame.outcome.statistics);
}

/// The scene drawn frame after frame, and beside each the fixed load: a frozen frame's indirect
/// light, traced anew each time with the same random numbers.
class Course {
 public:
    Course(FrameLoop& loop, FrameLoop& fixed) : loop_(loop), fixed_(fixed) {}

    core::Result<void> setLoad(const Load& load) {
        loop_.request.size = load.size;
        TRY(loop_.request.camera, chooseCamera(loop_.snapshot(), load.camera));
        return {};
    }
    core::Result<Cost> draw(const photon_gi::Settings& settings) {
        loop_.request.settings = settings;
        TRY(const photon_gi::IndirectCost before, drawOnce(fixed_, 0));
        TRY(const photon_gi::IndirectCost raw, drawOnce(loop_, number_++));
        recent_.push_back(before.sum());
        if (recent_.size() > kLoadFrames) recent_.pop_front();
        const std::vector<double> loads(recent_.begin(), recent_.end());
        const double now = summarise(loads).median;
        if (first_.size() < kFirstFrames) first_.push_back(before.sum());
        return Cost{raw, raw.times(summarise(first_).median / now), now};
    }
    /// Median of some frames' scaled milliseconds, after as many that are not measured.
    core::Result<double> measure(const photon_gi::Settings& settings, uint32_t frames) {
        std::vector<double> scaled;
        for (uint32_t i = 0; i < 2 * frames; ++i) {
            TRY(const Cost cost, draw(settings));
            if (i >= frames) scaled.push_back(cost.scaled.sum());
        }
        return summarise(scaled).median;
    }

 private:
    FrameLoop& loop_;
    FrameLoop& fixed_;
    uint64_t number_ = 0;
    std::deque<double> recent_;
    std::vector<double> first_;
};

/// Frames of a step of the load: those that may miss the budget, and those that are judged.
struct Length {
    uint32_t toMeet, judged;
};

struct Step {
    Load load;
    double median = 0.0, raw = 0.0, fixedLoad = 0.0;  ///< of the frames judged
    photon_gi::BudgetState before, after;
};

core::Result<Step> run(Course& course, photon_gi::Budget& budget, const Load& load,
                       const photon_gi::Settings& asked, const Length& length, Table& frames) {
    Step step{load, 0.0, 0.0, 0.0, budget.state(), {}};
    TRY_VOID(course.setLoad(load));
    std::vector<double> scaled, raw, fixedLoad;
    for (uint32_t i = 0; i < length.toMeet + length.judged; ++i) {
        const photon_gi::Settings given = budget.next(asked, load.size);
        TRY(const Cost cost, course.draw(given));
        budget.learn(cost.scaled);
        frames.rows.push_back(
            {fmt::format("{}", frames.rows.size()), fmt::format("{:.3f}", cost.scaled.sum()),
             fmt::format("{:.3f}", cost.raw.sum()), fmt::format("{:.3f}", cost.fixedLoad),
             fmt::format("{}", given.photonPaths), fmt::format("{:.4f}", given.radiusMetres),
             fmt::format("{}", given.gatherRays), fmt::format("{}", given.gatherDivisor)});
        if (i < length.toMeet) continue;
        scaled.push_back(cost.scaled.sum());
        raw.push_back(cost.raw.sum());
        fixedLoad.push_back(cost.fixedLoad);
    }
    step.median = summarise(scaled).median;
    step.raw = summarise(raw).median;
    step.fixedLoad = summarise(fixedLoad).median;
    step.after = budget.state();
    return step;
}

std::vector<std::string> rowOf(size_t number, const Step& step) {
    const double ratio = step.median / step.after.wantedMilliseconds;
    return {fmt::format("{}", number + 1),
            fmt::format("{}x{} {}", step.load.size.width, step.load.size.height, step.load.camera),
            fmt::format("{:.2f}", step.median),
            fmt::format("{:.3f}", ratio),
            std::abs(ratio - 1.0) <= kMostOff ? "yes" : "no",
            fmt::format("{:.2f}", step.raw),
            fmt::format("{:.2f}", step.fixedLoad),
            fmt::format("{:.2f}", step.after.quality),
            fmt::format("{}", step.after.changes - step.before.changes),
            fmt::format("{}", step.after.begun - step.before.begun),
            photon_gi::whatWasGivenUp(step.after.asked, step.after.given)};
}

/// Midway between what the lighter load takes at most and the heavier one at least.
core::Result<double> chooseMilliseconds(Course& course, const Load& light, const Load& heavy,
                                        const photon_gi::Settings& asked) {
    constexpr uint32_t kFrames = 10;
    const photon_gi::CostCurve curve(asked, heavy.size);
    TRY_VOID(course.setLoad(light));
    TRY_VOID(course.measure(asked, kFirstFrames / 2));
    TRY(const double most, course.measure(asked, kFrames));
    TRY_VOID(course.setLoad(heavy));
    TRY(const double least, course.measure(curve.settingsAt(curve.least()), kFrames));
    if (most <= least)
        return core::error(
            "bench budget: the light load takes {:.1f} ms at most, the heavy one {:.1f} at least: "
            "no budget meets both",
            most, least);
    return std::sqrt(most * least);
}

core::Result<std::unique_ptr<FrameLoop>> openFixedLoad(Options options, graph::Extent size) {
    options.size = size;
    options.timestep = 0.0;
    options.reseed = false;
    options.retrace = photon_gi::Retrace::All;
    TRY(auto loop, FrameLoop::open(options));
    loop->request.settings.shadows = false;
    loop->request.settings.gatherRays = 1;
    return loop;
}

}  // namespace

core::Result<void> benchBudget(const BenchCall& call) {
    Options options = call.options;
    options.scene = courtyard::kSceneName;
    options.retrace = photon_gi::Retrace::Auto;  // as in `view`
    const graph::Extent large =
        options.size.value_or(call.quick ? graph::Extent{160, 90} : graph::Extent{320, 180});
    const graph::Extent small{std::max(1u, large.width * 3 / 4),
                              std::max(1u, large.height * 3 / 4)};
    options.size = large;
    const std::vector<Load> loads{{small, "square"}, {large, "square"}, {small, "square"},
                                  {large, "arcade"}, {large, "square"}, {small, "arcade"}};
    photon_gi::Settings asked = settingsOf(options);
    asked.shadows = false;  // direct light is not what is measured
    options.timestep = kTimestep;
    TRY(const auto loop, FrameLoop::open(options));
    TRY(const auto fixed, openFixedLoad(options, small));
    Course course(*loop, *fixed);
    TRY(const double wanted, chooseMilliseconds(course, loads[0], loads[1], asked));
    photon_gi::Budget budget(wanted);
    Table table{"budget",
                {},
                {"step", "load", "ms", "÷ budget", "met", "raw ms", "fixed load ms", "quality",
                 "changes", "of divisor", "given up"},
                {}};
    Table frames{"budget_frames",
                 {},
                 {"frame", "ms", "raw ms", "fixed load ms", "paths", "radius", "rays", "divisor"},
                 {}};
    const Length length{options.warmup.value_or(60), options.frames.value_or(20)};
    const size_t steps = call.quick ? 3 : loads.size();
    Progress progress{"step of the load", steps};
    for (size_t i = 0; i < steps; ++i) {
        progress.show(i);
        TRY(const Step step, run(course, budget, loads[i], asked, length, frames));
        table.rows.push_back(rowOf(i, step));
    }
    table.title = fmt::format(
        "courtyard moving, budget {:.1f} ms of indirect light; asked for {}, {} paths; medians "
        "of {} frames, {} after each step; ms scaled by a fixed load drawn turn by turn; on {}",
        wanted, name(options.quality), asked.photonPaths, length.judged, length.toMeet,
        loop->device().info().name);
    if (!call.out.empty())
        TRY_VOID(core::writeFile(call.out / (frames.name + ".csv"), toCsv(frames)));
    return publish(table, call.out);
}

}  // namespace lampyris::sandbox
