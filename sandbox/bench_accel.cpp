// `lampyris bench accel`: how long the BVHs of the built-in scenes take to build, and what scenes
// need.
#include <fmt/format.h>
#include <sys/resource.h>

#include "bench.h"
#include "progress.h"
#include "scene/builtin/builtin.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

std::string mebibytes(uint64_t bytes) {
    return fmt::format("{:.1f}", static_cast<double>(bytes) / 1048576.0);
}

/// The most memory that this process has held so far.
uint64_t peakBytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<uint64_t>(usage.ru_maxrss) * 1024;
}

core::Result<std::vector<std::string>> measure(const Options& options) {
    TRY(const auto loop, FrameLoop::open(options));
    const accel::AccelCounts counts = loop->renderer().accel().counts();
    TRY(const LoopFrame frame, loop->draw(0));
    return std::vector<std::string>{options.scene,
                                    fmt::format("{}", counts.triangles),
                                    fmt::format("{}", counts.blas),
                                    fmt::format("{:.0f}", counts.buildMilliseconds),
                                    fmt::format("{}", counts.deepest),
                                    mebibytes(loop->renderer().accel().deviceBytes()),
                                    mebibytes(frame.outcome.statistics.deviceBytes),
                                    mebibytes(peakBytes())};
}

}  // namespace

core::Result<void> benchAccel(const BenchCall& call) {
    Table table{"accel",
                "BVH of each built-in scene: wall time of building and flattening all of it, and "
                "memory after a frame",
                {"scene", "triangles", "BLASes", "build ms", "stack", "BVH MiB", "device MiB",
                 "peak MiB so far"},
                {}};
    // Small scenes first: the peak is the process's.
    std::vector<std::string> scenes{"cornell", "two_rooms", "conference", "cornell_statue"};
    if (!call.quick) scenes.emplace_back("cornell_hairball");
    Progress progress{"scene", scenes.size()};
    for (const std::string& scene : scenes) {
        progress.show(table.rows.size());
        Options options = call.options;
        options.scene = scene;
        TRY(auto row, measure(options));
        table.rows.push_back(std::move(row));
    }
    return publish(table, call.out);
}

}  // namespace lampyris::sandbox
