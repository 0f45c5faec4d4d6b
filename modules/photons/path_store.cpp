#include "photons/path_store.h"

#include <algorithm>

#include "photons/shaders.h"

namespace lampyris::photons {
namespace {

// [chosen] Boxes that a path's segments are held against; what is more counts as one around them.
constexpr size_t kMostBoxes = 16;

/// What lies on a box: hits are rounded, and paths leave a surface from in front of it, twice as
/// far here as `lib/emission.glsl` has it. [chosen] a millimetre at the least
float marginOf(const math::Bounds& box) {
    return 1e-3f + 2e-5f * glm::length(glm::max(glm::abs(box.lower), glm::abs(box.upper)));
}

/// Of the boxes, wider by their margin.
std::vector<glm::vec4> cornersOf(std::span<const math::Bounds> boxes) {
    std::vector<math::Bounds> few;
    for (const math::Bounds& box : boxes) {
        if (few.size() < kMostBoxes)
            few.push_back(box);
        else
            few.back().grow(box);
    }
    std::vector<glm::vec4> corners;
    for (const math::Bounds& box : few) {
        corners.emplace_back(box.lower - marginOf(box), 0.0f);
        corners.emplace_back(box.upper + marginOf(box), 0.0f);
    }
    return corners;
}

uint32_t groupsOf(uint32_t paths) {
    return (paths + shared::TRACE_THREADS - 1) / shared::TRACE_THREADS;
}

}  // namespace

bool fitsStore(uint32_t paths, uint32_t maxBounces) {
    constexpr uint64_t kStorageRange = uint64_t{128} << 20;
    const uint64_t perPath = std::max({uint64_t{maxBounces} * sizeof(shared::PackedPhoton),
                                       uint64_t{verticesPerPath(maxBounces)} * sizeof(glm::vec4),
                                       uint64_t{shared::BOOKING_FLOATS} * sizeof(float)});
    return paths * perPath <= kStorageRange;
}

PathStore::PathStore(residency::Device& device)
    : staged_(device, "kept photons"),
      counts_(device, "kept path counts"),
      vertices_(device, "kept path vertices"),
      bookings_(device, "kept bookings") {}

core::Result<void> PathStore::reserve(uint32_t paths, uint32_t photonsPerPath,
                                      uint32_t maxBounces) {
    const uint64_t count = std::max(paths, 1u);
    TRY_VOID(staged_.reserve(count * std::max(photonsPerPath, 1u) * sizeof(shared::PackedPhoton)));
    TRY_VOID(counts_.reserve(count * sizeof(uint32_t)));
    TRY_VOID(vertices_.reserve(count * verticesPerPath(maxBounces) * sizeof(glm::vec4)));
    return bookings_.reserve(count * shared::BOOKING_FLOATS * sizeof(float));
}

PathStoreHandles PathStore::import(graph::Frame& frame) {
    constexpr const char* kNever = "upload kept paths";
    return {staged_.import(frame, kNever), counts_.import(frame, kNever),
            vertices_.import(frame, kNever), bookings_.import(frame, kNever)};
}

uint64_t PathStore::bytes() const {
    return staged_.bytes() + counts_.bytes() + vertices_.bytes() + bookings_.bytes();
}

ChosenPaths addPathChoice(graph::Frame& frame, const PathStoreHandles& store,
                          const PathSplit& split, const PathChoice& choice, uint32_t maxBounces,
                          graph::Buffer counters) {
    std::vector<glm::vec4> corners = cornersOf(choice.boxes);
    const shared::ChoiceParams params{split.paths,
                                      static_cast<uint32_t>(split.ranges.size()),
                                      static_cast<uint32_t>(corners.size() / 2),
                                      verticesPerPath(maxBounces),
                                      choice.turns,
                                      choice.turn,
                                      choice.all ? 1u : 0u,
                                      0};
    if (corners.empty()) corners.emplace_back();
    std::vector<uint32_t> again = choice.rangesAgain;
    again.resize(split.ranges.size(), 0u);
    auto node = frame.compute("photon_trace/choice", shaders::pathChoice);
    node.read(shared::SLOT_CHOICE_VERTICES, store.vertices)
        .storageData(shared::SLOT_CHOICE_BOXES, corners.data(), corners.size() * sizeof(glm::vec4))
        .storageData(shared::SLOT_PATH_RANGES, split.ranges.data(),
                     split.ranges.size() * sizeof(shared::PathRange))
        .storageData(shared::SLOT_CHOICE_AGAIN, again.data(), again.size() * sizeof(uint32_t))
        .push(params);
    ChosenPaths chosen;
    chosen.list = node.write(shared::SLOT_CHOSEN_PATHS,
                             frame.buffer("chosen paths", {split.paths * sizeof(uint32_t)}));
    chosen.counters = node.update(shared::SLOT_COUNTERS, counters);
    node.dispatch(groupsOf(split.paths));
    auto groups = frame.compute("photon_trace/groups", shaders::pathGroups);
    groups.read(shared::SLOT_COUNTERS, chosen.counters);
    chosen.groups = groups.write(shared::SLOT_CHOSEN_GROUPS,
                                 frame.buffer("chosen path groups", {3 * sizeof(uint32_t)}));
    groups.dispatch(1);
    return chosen;
}

graph::Buffer addPathLedger(graph::Frame& frame, graph::Buffer bookings, uint32_t paths) {
    auto node = frame.compute("photon_trace/ledger", shaders::pathLedger);
    node.read(shared::SLOT_BOOKINGS, bookings).push(shared::StoreParams{paths, 0, 0, 0});
    const graph::Buffer ledger = node.write(
        shared::SLOT_LEDGER,
        frame.buffer("energy ledger",
                     {uint64_t{groupsOf(paths)} * shared::LEDGER_FLOATS * sizeof(float)}));
    node.dispatch((groupsOf(paths) * 15 + 63) / 64);
    return ledger;
}

}  // namespace lampyris::photons
