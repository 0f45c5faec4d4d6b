#include "accel/refit_bench.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "accel/embree_refit.h"
#include "accel/refit_cpu.h"
#include "accel/refit_nodes.h"
#include "accel/tree_store.h"
#include "residency/pack_scene.h"

namespace lampyris::accel {
namespace {

using Clock = std::chrono::steady_clock;
using Times = std::map<std::string, std::vector<double>>;

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

template <typename Work>
double timed(const Work& work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Twisted and waving: every vertex moves, no box grows out of proportion.
std::vector<glm::vec3> wave(const assets::Mesh& mesh, uint32_t phase) {
    std::vector<glm::vec3> positions = mesh.positions;
    const glm::vec3 extent = mesh.bounds.extent();
    for (glm::vec3& p : positions) {
        const float height = (p.y - mesh.bounds.lower.y) / std::max(extent.y, 1e-6f);
        p.x += 0.05f * extent.x * std::sin(6.0f * height + 0.7f * static_cast<float>(phase));
        p.z += 0.05f * extent.z * std::cos(5.0f * height + 0.9f * static_cast<float>(phase));
    }
    return positions;
}

math::Bounds boundsOf(const std::vector<glm::vec3>& positions) {
    math::Bounds bounds;
    for (const glm::vec3& p : positions) bounds.grow(p);
    return bounds;
}

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

/// Copies of one mesh, a tree each, on the device and on the CPU.
class Trees {
 public:
    Trees(execute::Executor& executor, const assets::Mesh& mesh)
        : executor_(&executor),
          mesh_(&mesh),
          store_(executor.device()),
          positions_(executor.device(), "bench positions", sizeof(residency::DevicePosition)),
          indices_(executor.device(), "bench indices", sizeof(uint32_t)) {}

    core::Result<void> load(uint32_t copies) {
        TreeBuilder builder;
        TRY(const Blas built,
            buildPosedBlas(builder, {mesh_->positions, mesh_->indices}, mesh_->bounds));
        slots_ = listSlots(built.tree);
        corners_ = leafCorners(built.tree, mesh_->indices);
        for (uint32_t i = 0; i < copies; ++i) {
            trees_.push_back(built.tree);
            ranges_.push_back(
                store_.take(built.tree.nodes.size(), built.triangles.size(), slots_.texels.size()));
            relocate(trees_.back(), ranges_.back());
        }
        TRY_VOID(store_.reserve());
        TRY_VOID(positions_.reserve(copies * mesh_->positions.size() *
                                    sizeof(residency::DevicePosition)));
        TRY_VOID(indices_.reserve(bytesOf(mesh_->indices).size()));
        TRY(residency::Loading loading, residency::Loading::begin(executor_->device()));
        TRY_VOID(loading.write(indices_, 0, bytesOf(mesh_->indices)));
        for (uint32_t i = 0; i < copies; ++i) {
            const TreeRange& r = ranges_[i];
            TRY_VOID(
                loading.write(store_.nodes, r.firstNode * sizeof(Node), bytesOf(trees_[i].nodes)));
            TRY_VOID(loading.write(store_.triangles, r.firstTriangle * sizeof(LeafTriangle),
                                   bytesOf(built.triangles)));
            TRY_VOID(loading.write(store_.slots, r.firstSlot * sizeof(uint32_t),
                                   bytesOf(slots_.texels)));
        }
        return loading.finish();
    }

    core::Result<void> move(uint32_t tree, const std::vector<glm::vec3>& to) {
        trees_[tree].grid = gridAround(boundsOf(to));
        const auto packed = residency::packPositions(to);
        return positions_.stage(tree * bytesOf(packed).size(), bytesOf(packed));
    }

    /// Refits the first trees on the device; adds a time for each reported name, and their sum.
    core::Result<void> refitOnDevice(uint32_t count, const std::string& sum, Times& times) {
        std::vector<RefitJob> jobs;
        for (uint32_t i = 0; i < count; ++i)
            jobs.push_back({trees_[i].grid, static_cast<uint32_t>(ranges_[i].firstNode),
                            static_cast<uint32_t>(ranges_[i].nodes),
                            static_cast<uint32_t>(ranges_[i].firstSlot), slots_.levels,
                            i * static_cast<uint32_t>(mesh_->positions.size()), 0});
        graph::Frame frame;
        const RefitBuffers buffers{store_.nodes.import(frame, "upload nodes"),
                                   store_.triangles.import(frame, "upload triangles"),
                                   store_.slots.import(frame, "upload slots"),
                                   positions_.import(frame, "upload positions"),
                                   indices_.import(frame, "upload indices")};
        frame.output(addRefit(frame, buffers, jobs).quality);
        TRY(const auto done, executor_->run(frame));
        std::map<std::string, double> all;
        for (const auto& node : done.statistics.nodes) {
            if (!node.name.starts_with("refit")) continue;
            all[node.name.substr(0, node.name.find('/'))] += node.gpuMilliseconds;
            all[sum] += node.gpuMilliseconds;
        }
        for (const auto& [name, milliseconds] : all) times[name].push_back(milliseconds);
        return {};
    }

    /// Refits the first trees on the CPU, all at the same positions; nothing goes to the device
    /// yet.
    core::Result<double> refitOnCpu(uint32_t count, const std::vector<glm::vec3>& positions) {
        double milliseconds = 0.0;
        for (uint32_t i = 0; i < count; ++i) {
            const TreeRange& r = ranges_[i];
            TRY(const auto room, store_.triangles.stageRoom(r.firstTriangle * sizeof(LeafTriangle),
                                                            r.triangles * sizeof(LeafTriangle)));
            const std::span corners(reinterpret_cast<LeafTriangle*>(room.data()), r.triangles);
            milliseconds += timed([&] {
                accel::refitOnCpu({trees_[i], static_cast<uint32_t>(r.firstNode),
                                   static_cast<uint32_t>(r.firstTriangle), corners, corners_},
                                  positions);
            });
        }
        return milliseconds;
    }

    /// Sends what refitOnCpu() left: staging of nodes on the CPU and both copies on the device, ms.
    core::Result<double> upload() {
        core::Result<void> staged;
        double milliseconds = timed([&] {
            staged =
                store_.nodes.stage(ranges_[0].firstNode * sizeof(Node), bytesOf(trees_[0].nodes));
        });
        if (!staged.ok()) return staged.error();
        graph::Frame frame;
        frame.output(store_.nodes.import(frame, "upload nodes"));
        frame.output(store_.triangles.import(frame, "upload triangles"));
        TRY(const auto done, executor_->run(frame));
        for (const auto& node : done.statistics.nodes) milliseconds += node.gpuMilliseconds;
        return milliseconds;
    }

    [[nodiscard]] const Tree& first() const { return trees_.front(); }

 private:
    execute::Executor* executor_;
    const assets::Mesh* mesh_;
    TreeStore store_;
    residency::ResidentBuffer positions_, indices_;
    std::vector<Tree> trees_;
    std::vector<TreeRange> ranges_;
    RefitSlots slots_;
    std::vector<uint32_t> corners_;
};

}  // namespace

core::Result<RefitTimes> measureRefit(execute::Executor& executor, const assets::Mesh& mesh,
                                      uint32_t repeats) {
    Trees trees(executor, mesh);
    TRY_VOID(trees.load(1));
    TRY(EmbreeRefit embree, EmbreeRefit::create(mesh.positions, mesh.indices));
    TreeBuilder builder;
    Times times;
    for (uint32_t i = 0; i <= repeats; ++i) {
        if (i == 1) times.clear();  // shaders are compiled, memory is there
        const auto positions = wave(mesh, i);
        TRY_VOID(trees.move(0, positions));
        TRY_VOID(trees.refitOnDevice(1, "device", times));
        TRY(const double cpu, trees.refitOnCpu(1, positions));
        TRY(const double upload, trees.upload());
        times["cpu"].push_back(cpu);
        times["upload"].push_back(upload);
        times["embree"].push_back(embree.refit(positions));
        core::Result<Blas> built = core::error("not built");
        times["rebuild"].push_back(timed([&] {
            built = buildPosedBlas(builder, {positions, mesh.indices}, boundsOf(positions));
            if (built.ok()) static_cast<void>(listSlots(built->tree));
        }));
        TRY_VOID(built.ok() ? core::Result<void>{} : core::Result<void>{built.error()});
    }
    const auto of = [&](const char* name) { return median(times.at(name)); };
    return RefitTimes{mesh.triangleCount(), static_cast<uint32_t>(trees.first().nodes.size()),
                      trees.first().depth,  of("refit_leaves"),
                      of("refit_levels"),   of("refit_sah"),
                      of("device"),         of("cpu"),
                      of("upload"),         of("rebuild"),
                      of("embree")};
}

core::Result<RefitShare> measureShare(execute::Executor& executor, const assets::Mesh& mesh,
                                      uint32_t copies, uint32_t repeats) {
    Trees trees(executor, mesh);
    TRY_VOID(trees.load(copies));
    Times times;
    for (uint32_t i = 0; i <= repeats; ++i) {
        if (i == 1) times.clear();
        const auto positions = wave(mesh, i);
        for (uint32_t tree = 0; tree < copies; ++tree) TRY_VOID(trees.move(tree, positions));
        TRY_VOID(trees.refitOnDevice(copies, "all", times));
        TRY_VOID(trees.refitOnDevice(1, "one", times));
        TRY(const double all, trees.refitOnCpu(copies, positions));
        TRY(const double one, trees.refitOnCpu(1, positions));
        TRY(const double upload, trees.upload());
        static_cast<void>(upload);
        times["all cpu"].push_back(all);
        times["one cpu"].push_back(one);
    }
    return RefitShare{copies,
                      mesh.triangleCount(),
                      median(times.at("one")),
                      median(times.at("all")),
                      median(times.at("one cpu")),
                      median(times.at("all cpu"))};
}

}  // namespace lampyris::accel
