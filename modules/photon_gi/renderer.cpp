#include "photon_gi/renderer.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "core/check.h"

#include "deferred/shadow.h"
#include "deferred/view.h"
#include "photon_gi/composite.h"
#include "photon_gi/tile_bin.h"
#include "photons/irradiance_grid.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {
namespace {

// [chosen] First guesses; a frame that needs more reports it and the next one has it.
constexpr uint32_t kPhotonsPerPathGuess = 4;
constexpr uint32_t kPairsPerPhotonGuess = 64;
constexpr uint32_t kLeastPairs = 1u << 16;
// Batches fit into 0.8 of the largest room; where they need less than half of that, they double.
constexpr double kRoomForTwice = 0.4;  // [chosen]
constexpr uint64_t kMostPairsGuessed = 1u << 22;

/// Half as much again, in steps that keep the graph's layout from changing at every frame.
uint32_t grown(uint32_t needed, uint32_t most) {
    constexpr uint64_t kStep = 1024;
    const uint64_t wanted = uint64_t{needed} + needed / 2;
    return static_cast<uint32_t>(std::min<uint64_t>((wanted + kStep - 1) / kStep * kStep, most));
}

std::vector<float> floats(std::span<const std::byte> bytes) {
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    return values;
}

/// In the order in which run() asked for the buffers.
/// \return the paths' importance, where the frame measured it
std::vector<float> readReport(const DrawnFrame& drawn,
                              const std::vector<std::vector<std::byte>>& buffers,
                              FrameReport& report) {
    size_t next = 0;
    std::vector<float> importance;
    if (drawn.counters.valid())
        std::memcpy(&report.counters, buffers[next++].data(), sizeof(report.counters));
    if (drawn.importance.valid()) importance = floats(buffers[next++]);
    const std::vector<float> reach = floats(buffers[next++]);
    CHECK(reach.size() >= size_t{3});
    for (int c = 0; c < 3; ++c)
        report.cutOffWatts[c] = reach[reach.size() - 3 + static_cast<size_t>(c)];
    while (next < buffers.size()) report.energy.add(floats(buffers[next++]));
    return importance;
}

}  // namespace

Renderer::Renderer(execute::Executor& executor, const accel::AccelSettings& accel)
    : executor_(&executor),
      scene_(executor.device()),
      accel_(scene_, accel),
      keeper_(executor.device()) {}

core::Result<void> Renderer::update(const scene::SceneSnapshot& snapshot) {
    TRY_VOID(scene_.update(snapshot));
    TRY_VOID(accel_.update(snapshot, &eyeWorld_));
    emitters_ = photons::listEmitters(snapshot.lights, scene_.emitters());
    scene::add(changes_, scene::changesBetween(snapshot_, snapshot));
    snapshot_ = snapshot;
    return {};
}

core::Result<void> Renderer::makeRoom(const FrameRequest& request) {
    Settings s = request.settings;
    s.largestBatch = std::min(s.largestBatch, largestBatch_);
    const auto newSplit = [&] {
        return guided(s) ? guide_.split(emitters_, s.photonPaths)
                         : photons::splitPaths(emitters_, s.photonPaths);
    };
    const PathKeeper::Now now{emitters_, snapshot_.lights, changes_, request.frameNumber};
    TRY(plan_, keeper_.plan(s, now, newSplit));
    const auto batches = photons::batchPaths(plan_.split, s.maxBounces, s.largestBatch);
    uint32_t largest = 0;
    for (const auto& b : batches) largest = std::max(largest, b.pathCount);
    const uint32_t perPath = photons::photonsPerPath(plan_.split, s.maxBounces);
    const uint64_t guess = uint64_t{largest} * std::min(perPath, kPhotonsPerPathGuess);
    lastBatch_ = largest;
    room_.photons = static_cast<uint32_t>(
        std::clamp<uint64_t>(guess, std::max(room_.photons, 64u), photons::kMaxPhotonCapacity));
    const uint64_t pairGuess = std::clamp<uint64_t>(uint64_t{room_.photons} * kPairsPerPhotonGuess,
                                                    kLeastPairs, kMostPairsGuessed);
    mostPairs_ = mostPairsBinned(request.size);
    room_.pairs = static_cast<uint32_t>(
        std::min<uint64_t>(std::max<uint64_t>(pairGuess, room_.pairs), mostPairs_));
    return {};
}

bool Renderer::seenAsDrawn(const shared::View& view) const {
    return drawn_.whole && changes_.none() &&
           drawn_.size == graph::Extent{view.width, view.height} &&
           drawn_.worldToClip == view.worldToClip;
}

bool Renderer::settled(const shared::View& view, const FrameRequest& request) const {
    return request.finalAlone && drawn_.keptFinal && keepsUnchanged(request.settings) &&
           seenAsDrawn(view) && drawn_.settings == request.settings &&
           stillFrames_ > historyFrames(request.settings);
}

Past Renderer::recall(const shared::View& view, const Settings& settings) {
    Past past;
    past.known =
        executor_->history().known(kHistoryMean, historyMean(view, settings.gatherDivisor));
    past.still =
        keepsUnchanged(settings) && seenAsDrawn(view) && sameDirectLight(drawn_.settings, settings);
    past.same = drawn_.whole && drawn_.size == graph::Extent{view.width, view.height} &&
                meanGoesOn(drawn_.settings, settings);
    stillFrames_ = past.still && past.same ? stillFrames_ + 1 : 0;
    past.worldToClip = drawn_.worldToClip;
    if (!past.same)
        framesSinceChange_ = settings.history;  // nothing is remembered
    else if (!changes_.none())
        framesSinceChange_ = 0;
    past.doubted = framesSinceChange_++ < settings.history;
    past.changes = std::exchange(changes_, {});
    past.lights = snapshot_.lights;
    const bool keeps = finalGathers(settings) && settings.history > 0 && settings.maxBounces > 0 &&
                       plan_.split.paths > 0;
    drawn_ = {keeps, false, settings, {view.width, view.height}, view.worldToClip};
    return past;
}

void Renderer::forget() {
    drawn_ = {};
    keeper_.forget();
}

core::Result<DrawnFrame> Renderer::declare(graph::Frame& frame, const FrameRequest& request) {
    const shared::View view = deferred::makeView(request.camera, request.size);
    if (settled(view, request)) {
        DrawnFrame last;
        last.radiance = recallFinal(frame, request.size);
        frame.publish(kFinal, last.radiance);
        treeQuality_ = {};
        return last;
    }
    TRY_VOID(makeRoom(request));
    FrameInputs in;
    in.scene = residency::importScene(frame, scene_);
    in.accel = accel::importAccel(frame, accel_, in.scene);
    treeQuality_ = in.accel.quality;
    eyeWorld_ = glm::vec3(request.camera.cameraToWorld[3]);
    in.draws = scene_.draws();
    in.paths = plan_.split;
    in.pathsKept = plan_.kept;
    if (plan_.kept) in.store = keeper_.import(frame);
    in.choice = plan_.choice;
    in.view = view;
    in.seed = frameSeed(request.settings, request.frameNumber);
    in.turn = request.settings.reseed ? static_cast<uint32_t>(request.frameNumber) : 0;
    in.pathTurn = plan_.turn;
    in.past = recall(in.view, request.settings);
    in.settles = keepsUnchanged(request.settings) && request.finalAlone &&
                 stillFrames_ > historyFrames(request.settings);
    drawn_.keptFinal = in.settles;
    const Settings& asked = request.settings;
    shadows_ = asked.shadows && asked.pipeline != Pipeline::Thesis;
    Settings settings = request.settings;
    settings.largestBatch = std::min(settings.largestBatch, largestBatch_);
    return drawFrame(frame, in, settings, room_);
}

void Renderer::fitBatches(double share) {
    if (share > 1.0) {
        const uint32_t batch = std::min(largestBatch_, lastBatch_);
        largestBatch_ = std::max(1u, static_cast<uint32_t>(batch * std::min(0.8 / share, 0.9)));
    } else if (share > 0.0 && share < kRoomForTwice) {
        largestBatch_ = std::max(largestBatch_, 2 * std::min(largestBatch_, 0x7fffffffu));
    }
}

core::Result<bool> Renderer::grow(const shared::FrameCounters& counters) {
    const bool dropped = counters.photonsDropped > 0 || counters.pairsDropped > 0;
    const bool fullGrid = counters.cellsDropped > 0;
    if (fullGrid && room_.gridSlots >= room_.mostGridSlots)
        return core::error(
            "the irradiance grid is full: {} cells and no more find room at its largest; a larger "
            "--radius makes larger cells",
            counters.cells);
    if (fullGrid) room_.gridSlots = std::min(4 * room_.gridSlots, room_.mostGridSlots);
    const bool crowded = counters.mostInTile > kMostPhotonsInTile && lastBatch_ > 1;
    if (counters.photonsDropped > 0)
        room_.photons = grown(counters.photonsNeeded, photons::kMaxPhotonCapacity);
    if (counters.pairsDropped > 0) room_.pairs = grown(counters.pairsNeeded, mostPairs_);
    // What no room can hold, and tiles that no loop can walk, take smaller batches.
    const double most =
        std::max({static_cast<double>(counters.photonsNeeded) / photons::kMaxPhotonCapacity,
                  static_cast<double>(counters.pairsNeeded) / mostPairs_,
                  static_cast<double>(counters.mostInTile) / kMostPhotonsInTile});
    if (most > 1.0 || !dropped) fitBatches(most);
    return dropped || crowded || fullGrid;
}

core::Result<Renderer::Outcome> Renderer::run(graph::Frame& frame, const DrawnFrame& drawn,
                                              const std::string& outputNode,
                                              graph::CompileOptions options) {
    if (shadows_ && drawn.lightReach.valid())
        TRY_VOID(deferred::checkShadowCounts(scene_.lightCount(),
                                             scene_.device().limits().core.maxImageArrayLayers));
    execute::RunOptions runOptions;
    if (!outputNode.empty()) {
        const graph::Image image = frame.published(outputNode);
        if (!image.valid())
            return core::error("--output-node {}: there is no such image; there are {}", outputNode,
                               fmt::join(frame.publishedNames(), ", "));
        options.extraOutputs.push_back(image);
        runOptions.readBackImages.push_back(image);
    }
    if (drawn.counters.valid()) runOptions.readBackBuffers.push_back(drawn.counters);
    if (drawn.importance.valid()) runOptions.readBackBuffers.push_back(drawn.importance);
    if (drawn.lightReach.valid()) runOptions.readBackBuffers.push_back(drawn.lightReach);
    runOptions.readBackBuffers.insert(runOptions.readBackBuffers.end(), drawn.ledgers.begin(),
                                      drawn.ledgers.end());
    if (treeQuality_.valid()) runOptions.readBackBuffers.push_back(treeQuality_);
    for (const graph::Buffer buffer : runOptions.readBackBuffers) frame.output(buffer);

    Outcome outcome;
    outcome.radiance = drawn.radiance;
    options.memory = &executor_->memoryModel();
    TRY(outcome.graph, graph::compile(frame, options));
    TRY(auto result, executor_->run(frame, outcome.graph, runOptions));
    outcome.statistics = std::move(result.statistics);
    if (!result.images.empty()) outcome.image = execute::toImage(result.images.front());
    if (!drawn.lightReach.valid()) {
        outcome.report = lastReport_;
        outcome.report.retraced = 0;
        return outcome;
    }
    if (treeQuality_.valid()) {
        accel_.learn(result.buffers.back());
        result.buffers.pop_back();
    }
    const auto importance = readReport(drawn, result.buffers, outcome.report);
    outcome.report.paths = drawn.ledgers.empty() ? 0 : plan_.split.paths;
    outcome.report.retraced =
        plan_.kept ? outcome.report.counters.pathsRetraced : outcome.report.paths;
    TRY(const bool lacking, grow(outcome.report.counters));
    outcome.report.valid = !lacking;
    if (!outcome.report.valid)
        drawn_.whole = false;  // its light is not all there
    else if (!importance.empty())
        guide_.learn(plan_.split, importance);
    lastReport_ = outcome.report;
    return outcome;
}

core::Result<Renderer::Outcome> Renderer::draw(const scene::SceneSnapshot& snapshot,
                                               const FrameRequest& request,
                                               const std::string& outputNode) {
    TRY_VOID(update(snapshot));
    graph::Frame frame;
    TRY(DrawnFrame drawn, declare(frame, request));
    if (drawn_.keptFinal) {  // rests as what is kept does, which no caller need know
        auto node = frame.transfer("composite/copy");
        drawn.radiance =
            node.copy(drawn.radiance, frame.image("radiance", frame.desc(drawn.radiance)));
    }
    frame.output(drawn.radiance);
    return run(frame, drawn, outputNode);
}

}  // namespace lampyris::photon_gi
