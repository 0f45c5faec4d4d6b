// `lampyris bench soak`: thousands of frames of the courtyard in which things, lights and figures
// come and go at random. Fails where memory grows on, or the validation layer speaks.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench.h"
#include "courtyard/courtyard.h"
#include "courtyard/soak.h"
#include "progress.h"
#include "resident_memory.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

constexpr uint32_t kSettled = 500;    // [chosen] frames after which all is there that ever will be
constexpr double kMostGrowth = 1.05;  // [chosen] after those
constexpr double kMostResidentGrowth = 1.1;  // [chosen] a heap breathes
constexpr double kTimestep = 1.0 / 60.0;     // seconds

/// What is looked at in every frame.
enum What : uint8_t { DeviceMemory, SceneMemory, ResidentMemory, Entities, Lights, kWhats };
using Sample = std::array<uint64_t, kWhats>;

/// A sum over all frames, and the most in one.
struct Count {
    uint64_t sum = 0, most = 0;
    void add(uint64_t value) {
        sum += value;
        most = std::max(most, value);
    }
};

struct Soaking {
    uint32_t settled = 0;                  ///< the frame that memory is measured from
    Sample first{}, last{}, most{};        ///< `most` between the two
    Count repeats, photons, pairs, cells;  ///< dropped in what was repeated
    Dropped reported;                      ///< in frames that were reported as whole: none may be
    Count refits, rebuilds;
    uint64_t trianglesDropped = 0;     ///< at most
    std::vector<double> milliseconds;  ///< of the device
};

Sample look(FrameLoop& loop, const LoopFrame& frame) {
    return {frame.outcome.statistics.deviceBytes, loop.renderer().deviceBytes(), residentBytes(),
            loop.world().entityCount(), loop.snapshot().lights.size()};
}

void add(Soaking& soaking, FrameLoop& loop, const LoopFrame& frame, uint32_t frameNumber) {
    soaking.repeats.add(frame.repeats);
    soaking.photons.add(frame.dropped.photons);
    soaking.pairs.add(frame.dropped.pairs);
    soaking.cells.add(frame.dropped.cells);
    soaking.reported.add(frame.outcome.report.counters);
    soaking.refits.add(frame.refits);
    soaking.rebuilds.add(frame.rebuilds);
    soaking.trianglesDropped =
        std::max(soaking.trianglesDropped, loop.renderer().accel().counts().dropped);
    soaking.milliseconds.push_back(frame.outcome.statistics.gpuMilliseconds);
    if (frameNumber < soaking.settled) return;
    soaking.last = look(loop, frame);
    if (frameNumber == soaking.settled) soaking.first = soaking.last;
    for (size_t i = 0; i < kWhats; ++i)
        soaking.most[i] = std::max(soaking.most[i], soaking.last[i]);
}

Table memoryTable(const Soaking& soaking, FrameLoop& loop, uint32_t frames) {
    Table table{"soak_memory",
                {},
                {"what", fmt::format("frame {}", soaking.settled),
                 fmt::format("frame {}", frames - 1), "most between"},
                {}};
    table.title = fmt::format(
        "courtyard, {}x{}, {} frames in which things come and go; median frame {:.1f} ms on {}",
        loop.request.size.width, loop.request.size.height, frames,
        summarise(soaking.milliseconds).median, loop.device().info().name);
    const auto row = [&](const char* name, What what, double unit, int digits) {
        std::vector<std::string> cells{name};
        for (const Sample* sample : {&soaking.first, &soaking.last, &soaking.most})
            cells.push_back(
                fmt::format("{:.{}f}", static_cast<double>((*sample)[what]) / unit, digits));
        table.rows.push_back(std::move(cells));
    };
    constexpr double kMebibyte = 1 << 20;
    row("device memory, MiB", DeviceMemory, kMebibyte, 1);
    row("of it scene, BVH and kept paths, MiB", SceneMemory, kMebibyte, 1);
    row("resident memory of the process, MiB", ResidentMemory, kMebibyte, 1);
    row("entities", Entities, 1.0, 0);
    row("lights", Lights, 1.0, 0);
    return table;
}

Table countTable(const Soaking& soaking, FrameLoop& loop) {
    Table table{"soak_counts", "What was counted over all frames", {"what", "sum", "most"}, {}};
    const auto row = [&](const char* name, const Count& count) {
        table.rows.push_back({name, fmt::format("{}", count.sum), fmt::format("{}", count.most)});
    };
    row("frames drawn again for want of room", soaking.repeats);
    row("photons dropped in those", soaking.photons);
    row("tile entries dropped in those", soaking.pairs);
    row("grid cells dropped in those", soaking.cells);
    const Dropped& reported = soaking.reported;
    table.rows.push_back({"dropped in frames that were reported",
                          fmt::format("{}", reported.photons + reported.pairs + reported.cells),
                          ""});
    row("BVHs refitted", soaking.refits);
    row("BVHs rebuilt or built", soaking.rebuilds);
    table.rows.push_back(
        {"triangles that cannot be hit", "", fmt::format("{}", soaking.trianglesDropped)});
    table.rows.push_back({"validation messages",
                          loop.device().validated()
                              ? fmt::format("{}", loop.device().validationMessages().size())
                              : "off",
                          ""});
    return table;
}

core::Result<void> judge(const Soaking& soaking, FrameLoop& loop) {
    const std::vector<std::string> messages = loop.device().validationMessages();
    if (!messages.empty())
        return core::error("bench soak: {} validation messages, the first: {}", messages.size(),
                           messages.front().substr(0, messages.front().find('\n')));
    if (soaking.settled < kSettled) return {};  // too short a run to tell growth from a beginning
    struct Memory {
        What what;
        const char* name;
        double mostGrowth;
    };
    constexpr std::array<Memory, 3> kMemories{
        {{DeviceMemory, "device memory", kMostGrowth},
         {SceneMemory, "the scene's device memory", kMostGrowth},
         {ResidentMemory, "resident memory", kMostResidentGrowth}}};
    for (const Memory& memory : kMemories) {
        const auto before = static_cast<double>(soaking.first[memory.what]);
        const auto after = static_cast<double>(soaking.last[memory.what]);
        if (after > memory.mostGrowth * before)
            return core::error("bench soak: {} grew from {:.1f} to {:.1f} MiB after frame {}",
                               memory.name, before / (1 << 20), after / (1 << 20), soaking.settled);
    }
    return {};
}

}  // namespace

core::Result<void> benchSoak(const BenchCall& call) {
    Options options = call.options;
    options.scene = courtyard::kSceneName;
    options.size = options.size.value_or(graph::Extent{160, 90});
    options.timestep = kTimestep;
    options.retrace = photon_gi::Retrace::Auto;
    const uint32_t frames = options.frames.value_or(call.quick ? 600 : 10000);
    TRY(const auto loop, FrameLoop::open(options));
    courtyard::addSoak(loop->world(), options.seed);
    Soaking soaking;
    soaking.settled = frames > kSettled ? kSettled : frames / 2;
    Progress progress{"frame", frames};
    for (uint32_t i = 0; i < frames; ++i) {
        progress.show(i);
        TRY(const LoopFrame frame, loop->draw(i));
        add(soaking, *loop, frame, i);
    }
    TRY_VOID(publish(memoryTable(soaking, *loop, frames), call.out));
    TRY_VOID(publish(countTable(soaking, *loop), call.out));
    return judge(soaking, *loop);
}

}  // namespace lampyris::sandbox
