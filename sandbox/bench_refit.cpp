// `lampyris bench refit`: what moving vertices cost the BVH, on either path, beside rebuilding and
// Embree's own refit; and how little one mesh of many costs.
#include "accel/refit_bench.h"

#include <fmt/format.h>

#include "bench.h"
#include "scene/builtin/statue.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

constexpr uint32_t kMeshes = 100;

std::string milliseconds(double value) {
    return fmt::format("{:.2f}", value);
}

std::vector<std::string> goal(const char* what, double reached, double wanted) {
    return {what, fmt::format("{:.2f}", reached), fmt::format("{:.2f}", wanted),
            reached >= wanted ? "yes" : "no"};
}

/// A sphere of about 10,000 triangles.
assets::Mesh makeBall() {
    constexpr uint32_t kRings = 50, kSegments = 102;
    assets::Mesh mesh;
    for (uint32_t ring = 0; ring <= kRings; ++ring)
        for (uint32_t segment = 0; segment < kSegments; ++segment) {
            const float theta = math::kPi * static_cast<float>(ring) / kRings;
            const float phi = 2.0f * math::kPi * static_cast<float>(segment) / kSegments;
            mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                        std::sin(theta) * std::sin(phi));
        }
    for (uint32_t ring = 0; ring < kRings; ++ring)
        for (uint32_t segment = 0; segment < kSegments; ++segment) {
            const uint32_t a = ring * kSegments + segment;
            const uint32_t b = ring * kSegments + (segment + 1) % kSegments;
            if (ring > 0) mesh.indices.insert(mesh.indices.end(), {a, b, a + kSegments});
            if (ring + 1 < kRings)
                mesh.indices.insert(mesh.indices.end(), {b, b + kSegments, a + kSegments});
        }
    mesh.normals = mesh.positions;
    assets::updateBounds(mesh);
    return mesh;
}

Table timesTable(const accel::RefitTimes& t, uint32_t repeats, const std::string& device) {
    return {"refit",
            fmt::format("{} triangles deforming, {} nodes, {} levels: ms, medians of {} on {}",
                        t.triangles, t.nodes, t.depth, repeats, device),
            {"what", "ms"},
            {{"device: corners and leaves", milliseconds(t.leaves)},
             {"device: boxes by level", milliseconds(t.levels)},
             {"device: SAH cost", milliseconds(t.cost)},
             {"device: all", milliseconds(t.device)},
             {"CPU: corners, boxes, SAH cost", milliseconds(t.cpu)},
             {"CPU: upload beside", milliseconds(t.upload)},
             {"rebuild, MEDIUM, flattened", milliseconds(t.rebuild)},
             {"Embree's own refit", milliseconds(t.embree)}}};
}

Table shareTable(const accel::RefitShare& s, uint32_t repeats, const std::string& device) {
    const auto row = [](const char* path, double one, double all) {
        return std::vector<std::string>{path, fmt::format("{:.3f}", one),
                                        fmt::format("{:.3f}", all),
                                        fmt::format("{:.1f}", all / one)};
    };
    return {"refit_share",
            fmt::format("1 of {} meshes of {} triangles deforming: ms, medians of {} on {}",
                        s.meshes, s.triangles, repeats, device),
            {"path", "one", "all", "all ÷ one"},
            {row("device", s.oneOnDevice, s.allOnDevice), row("CPU", s.oneOnCpu, s.allOnCpu)}};
}

Table goalsTable(const accel::RefitTimes& t, const accel::RefitShare& s, bool cpuDevice) {
    const double better = std::min(t.device, t.cpu);
    const double own = cpuDevice ? s.allOnCpu / s.oneOnCpu : s.allOnDevice / s.oneOnDevice;
    return {"refit_goals",
            "Ratios beside what was aimed at",
            {"ratio", "reached", "wanted", "met"},
            {goal("rebuild ÷ the better path", t.rebuild / better, 20.0),
             goal("rebuild ÷ device", t.rebuild / t.device, 6.0),
             goal("Embree's refit ÷ the better path", t.embree / better, 1.0),
             goal("all of 100 ÷ one, by the path chosen here", own, 50.0)}};
}

}  // namespace

core::Result<void> benchRefit(const BenchCall& call) {
    Options options = call.options;
    TRY(const auto device, gpu::Device::create({options.device, options.validation, false}));
    TRY(execute::Executor executor, execute::Executor::create(*device));
    const uint32_t repeats = options.frames.value_or(call.quick ? 5 : 15);
    TRY(const accel::RefitTimes times,
        accel::measureRefit(executor, scene::builtin::makeStatue(), repeats));
    TRY_VOID(publish(timesTable(times, repeats, device->info().name), call.out));
    TRY(const accel::RefitShare share,
        accel::measureShare(executor, makeBall(), kMeshes, 2 * repeats));
    TRY_VOID(publish(shareTable(share, 2 * repeats, device->info().name), call.out));
    return publish(goalsTable(times, share, device->info().kind == "cpu"), call.out);
}

}  // namespace lampyris::sandbox
