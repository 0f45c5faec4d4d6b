#include "graph/place.h"

#include <random>

#include "graph/graph/graph_test.h"

namespace lampyris::graph {
namespace {

constexpr uint64_t kHuge = uint64_t{1} << 40;

Tenant tenant(uint32_t first, uint32_t last, uint64_t bytes, uint64_t alignment = 256,
              uint32_t kind = 0) {
    return {.firstStep = first,
            .lastStep = last,
            .need = {.bytes = bytes, .alignment = alignment, .memoryKind = kind}};
}

TEST(Place, LivesThatFollowEachOtherShareBytes) {
    std::vector<Tenant> tenants{tenant(0, 1, 1000), tenant(2, 3, 800), tenant(4, 9, 600)};
    const auto heaps = placeTenants(tenants, kHuge, true);
    ASSERT_EQ(heaps.size(), 1u);
    EXPECT_EQ(heaps[0].bytes, 1000u);
}

TEST(Place, ALifeThatEndsWhereAnotherBeginsOverlapsIt) {
    std::vector<Tenant> tenants{tenant(0, 1, 1024), tenant(1, 2, 1024)};
    EXPECT_EQ(placeTenants(tenants, kHuge, true)[0].bytes, 2048u);
}

TEST(Place, TheSmallestGapThatFitsIsTaken) {
    // Alive at step 5: only those at 1024..2048 and 2304..2560: gaps of 1024 and of 256 before the
    // end.
    std::vector<Tenant> tenants{tenant(0, 1, 1024), tenant(0, 9, 1023), tenant(0, 1, 256),
                                tenant(0, 9, 255), tenant(5, 5, 200)};
    const auto heaps = placeTenants(tenants, kHuge, true);
    EXPECT_EQ(tenants[2].offset, 2048u);
    EXPECT_EQ(tenants[4].offset, 2048u);
    EXPECT_EQ(heaps[0].bytes, 2304u + 255u);
}

TEST(Place, WithoutAliasingNothingIsShared) {
    std::vector<Tenant> tenants{tenant(0, 1, 1024), tenant(2, 3, 1024), tenant(4, 5, 1024)};
    EXPECT_EQ(placeTenants(tenants, kHuge, false)[0].bytes, 3072u);
}

TEST(Place, KindsOfMemoryLiveInHeapsOfTheirOwn) {
    std::vector<Tenant> tenants{tenant(0, 1, 1024, 256, 3), tenant(2, 3, 1024, 256, 5)};
    const auto heaps = placeTenants(tenants, kHuge, true);
    ASSERT_EQ(heaps.size(), 2u);
    EXPECT_EQ(heaps[tenants[0].heap].memoryKind, 3u);
    EXPECT_EQ(heaps[tenants[1].heap].memoryKind, 5u);
}

TEST(Place, HeapsStayBelowTheLimitUnlessOneThingIsAboveIt) {
    std::vector<Tenant> tenants{tenant(0, 9, 3000), tenant(0, 9, 1500), tenant(0, 9, 400)};
    const auto heaps = placeTenants(tenants, 2000, true);
    ASSERT_EQ(heaps.size(), 2u);
    EXPECT_EQ(heaps[0].bytes, 3000u);
    EXPECT_EQ(heaps[1].bytes, 1936u);
}

TEST(Place, RandomTenantsNeverMeetAndStandAligned) {
    std::mt19937_64 random(7);
    for (int round = 0; round < 200; ++round) {
        std::vector<Tenant> tenants;
        for (uint64_t i = 0; i < 30; ++i) {
            const auto first = static_cast<uint32_t>(random() % 20);
            const auto last = first + static_cast<uint32_t>(random() % 6);
            tenants.push_back(tenant(first, last, 1 + random() % 5000, 1u << random() % 12,
                                     static_cast<uint32_t>(random() % 2)));
        }
        const auto heaps = placeTenants(tenants, 20000, true);
        for (const Tenant& a : tenants) {
            const Heap& heap = heaps.at(a.heap);
            EXPECT_EQ(a.offset % a.need.alignment, 0u);
            EXPECT_EQ(heap.alignment % a.need.alignment, 0u);
            EXPECT_LE(a.offset + a.need.bytes, heap.bytes);
            EXPECT_EQ(heap.memoryKind, a.need.memoryKind);
            for (const Tenant& b : tenants) {
                EXPECT_TRUE(&a == &b || !livesOverlap(a, b) || !bytesOverlap(a, b));
            }
        }
    }
}

class Placement : public GraphTest {};

TEST_F(Placement, AChainTakesTheSpaceOfTwo) {
    Buffer last = source("first");
    for (int i = 0; i < 6; ++i) {
        auto node = compute("node");
        node.read(0, last);
        last = node.write(1, frame.buffer("buffer", kBytes));
    }
    frame.output(last);
    const CompiledGraph graph = compiled();
    EXPECT_EQ(graph.transientBytes, 2 * kBytes.bytes);
    EXPECT_EQ(graph.transientBytesWithoutAliasing, 7 * kBytes.bytes);
    EXPECT_EQ(compiled({.alias = false}).transientBytes, 7 * kBytes.bytes);
}

TEST_F(Placement, TheModelDecidesSizesAndKinds) {
    class Model : public MemoryModel {
     public:
        MemoryNeed image(const ImageDesc&, AccessSet accesses) const override {
            return {accesses.has(Access::StorageWrite) ? 5000u : 1u, 4096, 9};
        }
    };
    const Image image = compute("a").write(0, frame.image("x", kColour));
    frame.output(image);
    frame.output(source("b"));
    const Model model;
    const CompiledGraph graph = compiled({.memory = &model});
    ASSERT_EQ(graph.heaps.size(), 2u);
    EXPECT_EQ(graph.resources[image.resource].bytes, 5000u);
    EXPECT_EQ(graph.heaps[graph.resources[image.resource].heap].memoryKind, 9u);
    EXPECT_EQ(graph.heaps[graph.resources[image.resource].heap].alignment, 4096u);
}

TEST_F(Placement, WhatOutlivesTheFrameIsNotPlaced) {
    (void)compute("a").write(0, frame.importBuffer("store", kBytes, {}));
    const HistoryImage past = frame.history("past", kColour, true);
    (void)compute("b").write(0, past.current);
    const CompiledGraph graph = compiled();
    EXPECT_EQ(graph.transientBytes, 0u);
    EXPECT_TRUE(graph.heaps.empty());
}

}  // namespace
}  // namespace lampyris::graph
