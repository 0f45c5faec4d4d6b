#include "accel/rebuild_worker.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "accel/refit_cpu.h"

namespace lampyris::accel {
namespace {

// Of the box's extent and of its largest coordinate. [chosen] some tens of roundings
constexpr float kExtentMargin = 1e-5f;
constexpr float kReachMargin = 2e-6f;

using Clock = std::chrono::steady_clock;
using Task = std::packaged_task<core::Result<PosedBlas>(TreeBuilder&)>;

}  // namespace

math::Bounds treeBounds(const scene::PoseExtents& mesh, const scene::Pose& pose) {
    math::Bounds bounds = scene::posedBounds(mesh, pose);
    if (bounds.empty()) return bounds;
    const glm::vec3 extent = bounds.extent();
    const glm::vec3 reach = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
    const float margin = kExtentMargin * std::max({extent.x, extent.y, extent.z}) +
                         kReachMargin * std::max({reach.x, reach.y, reach.z});
    bounds.lower -= margin;
    bounds.upper += margin;
    return bounds;
}

core::Result<PosedBlas> buildPosed(TreeBuilder& builder, const assets::Mesh& mesh,
                                   const scene::Pose& pose) {
    const auto start = Clock::now();
    const auto positions = scene::posedVertices(mesh, pose).positions;
    PosedBlas built;
    TRY(built.blas, buildPosedBlas(builder, {positions, mesh.indices},
                                   treeBounds(scene::poseExtents(mesh), pose)));
    built.slots = listSlots(built.blas.tree);
    built.cost = costOf(built.blas.tree);
    built.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return built;
}

struct RebuildWorker::Parts {
    std::mutex mutex;
    std::condition_variable_any changed;
    std::deque<Task> tasks;
    std::jthread thread;  ///< last, so that it ends first

    void work(const std::stop_token& stop) {
        TreeBuilder builder;
        while (true) {
            Task task;
            {
                std::unique_lock lock(mutex);
                changed.wait(lock, stop, [this] { return !tasks.empty(); });
                if (stop.stop_requested()) return;
                task = std::move(tasks.front());
                tasks.pop_front();
            }
            task(builder);
        }
    }
};

RebuildWorker::RebuildWorker() : parts_(std::make_unique<Parts>()) {}
RebuildWorker::~RebuildWorker() = default;
RebuildWorker::RebuildWorker(RebuildWorker&&) noexcept = default;
RebuildWorker& RebuildWorker::operator=(RebuildWorker&&) noexcept = default;

std::future<core::Result<PosedBlas>> RebuildWorker::ask(std::shared_ptr<const assets::Mesh> mesh,
                                                        std::shared_ptr<const scene::Pose> pose,
                                                        std::stop_token forgotten) {
    Parts& p = *parts_;
    Task task([mesh = std::move(mesh), pose = std::move(pose),
               forgotten = std::move(forgotten)](TreeBuilder& builder) -> core::Result<PosedBlas> {
        if (forgotten.stop_requested()) return core::error("nobody waits for this tree");
        return buildPosed(builder, *mesh, *pose);
    });
    auto result = task.get_future();
    {
        const std::lock_guard lock(p.mutex);
        p.tasks.push_back(std::move(task));
    }
    // Few scenes ever rebuild: the thread begins with the first that does.
    if (!p.thread.joinable())
        p.thread = std::jthread([&p](const std::stop_token& stop) { p.work(stop); });
    p.changed.notify_one();
    return result;
}

}  // namespace lampyris::accel
