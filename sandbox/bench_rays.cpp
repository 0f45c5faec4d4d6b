// `lampyris bench rays`: closest hits of bounced rays in the shader, beside Embree on the same
// cores and rays.
#include <fmt/format.h>

#include "accel/ray_bench.h"
#include "bench.h"
#include "table.h"

namespace lampyris::sandbox {

core::Result<void> benchRays(const BenchCall& call) {
    Table table{"rays",
                {},
                {"scene", "triangles", "rays", "shader Mray/s", "Embree Mray/s", "shader ÷ Embree",
                 "hits that differ"},
                {}};
    accel::RayBenchSettings settings;
    if (call.quick) settings.paths /= 4;
    settings.repeats = call.options.frames.value_or(settings.repeats);
    for (const char* scene : {"cornell", "cornell_statue"}) {
        Options options = call.options;
        options.scene = scene;
        TRY(const auto loop, FrameLoop::open(options));
        TRY(const accel::RayRates rates,
            accel::measureRays(loop->executor(), loop->snapshot(), settings));
        table.rows.push_back(
            {scene, fmt::format("{}", rates.triangles), fmt::format("{}", rates.rays),
             fmt::format("{:.2f}", rates.gpuMraysPerSecond),
             fmt::format("{:.2f}", rates.embreeMraysPerSecond),
             fmt::format("{:.2f}", rates.ratio()), fmt::format("{}", rates.different)});
        table.title = fmt::format("Closest hits of diffusely bounced rays, medians of {} on {}",
                                  settings.repeats, loop->device().info().name);
    }
    return publish(table, call.out);
}

}  // namespace lampyris::sandbox
