#include <gtest/gtest.h>

#include "graph/compile.h"
#include "graph/graph/random_frame.h"
#include "support/contents_checker.h"
#include "support/cpu_executor.h"
#include "support/hazard_checker.h"

namespace lampyris::graph {
namespace {

using tests::ContentsChecker;
using tests::CpuExecutor;
using tests::HazardChecker;
using tests::RandomFrame;

constexpr uint64_t kFrames = 400;

std::vector<std::string> problems(const Frame& frame, const CompiledGraph& graph) {
    std::vector<std::string> found = HazardChecker(frame, graph).run();
    for (std::string& text : ContentsChecker(frame, graph).run()) found.push_back(std::move(text));
    return found;
}

std::vector<CompileOptions> waysToCompile(uint64_t seed) {
    return {{},
            {.randomOrderSeed = seed},
            {.poisonTransients = true},
            {.alias = false},
            {.randomOrderSeed = seed + 1, .poisonTransients = true}};
}

TEST(Hazards, RandomFramesHaveNone) {
    for (uint64_t seed = 1; seed <= kFrames; ++seed) {
        const RandomFrame random(seed);
        for (const CompileOptions& options : waysToCompile(seed)) {
            const auto graph = compile(random.frame, options);
            ASSERT_TRUE(graph.ok()) << "seed " << seed << ": " << graph.error().message;
            const auto found = problems(random.frame, *graph);
            ASSERT_TRUE(found.empty()) << "seed " << seed << ": " << found.front();
        }
    }
}

/// No barrier may be left out: which shows too that the checker sees each kind of hazard.
TEST(Hazards, EveryBarrierIsNeeded) {
    uint64_t removed = 0;
    for (uint64_t seed = 1; seed <= kFrames / 4; ++seed) {
        const RandomFrame random(seed);
        const auto whole = compile(random.frame, {.randomOrderSeed = seed});
        ASSERT_TRUE(whole.ok());
        for (size_t step = 0; step <= whole->steps.size(); ++step) {
            const bool last = step == whole->steps.size();
            const auto& barriers = last ? whole->finalBarriers : whole->steps[step].barriers;
            for (size_t i = 0; i < barriers.size(); ++i) {
                CompiledGraph broken = *whole;
                auto& left = last ? broken.finalBarriers : broken.steps[step].barriers;
                left.erase(left.begin() + static_cast<ptrdiff_t>(i));
                ASSERT_FALSE(problems(random.frame, broken).empty())
                    << "seed " << seed << " step " << step << " '"
                    << random.frame.resources()[barriers[i].resource].name
                    << "': " << describe(barriers[i].source) << " -> "
                    << describe(barriers[i].destination);
                ++removed;
            }
        }
    }
    EXPECT_GT(removed, 500u);
}

/// Nor may a barrier wait for less, or make less wait, than it does.
TEST(Hazards, EveryTouchOfABarrierIsNeeded) {
    const auto without = [](const TouchSet& touches, Touch left) {
        TouchSet rest;
        touches.forEach([&](Touch touch) {
            if (!(touch == left)) rest.add(touch);
        });
        return rest;
    };
    for (uint64_t seed = 1; seed <= kFrames / 4; ++seed) {
        const RandomFrame random(seed);
        const auto whole = compile(random.frame);
        ASSERT_TRUE(whole.ok());
        CompiledGraph broken = *whole;
        for (Step& step : broken.steps) {
            for (Barrier& barrier : step.barriers) {
                for (TouchSet* side : {&barrier.source, &barrier.destination}) {
                    const TouchSet all = *side;
                    all.forEach([&](Touch touch) {
                        *side = without(all, touch);
                        EXPECT_FALSE(problems(random.frame, broken).empty())
                            << "seed " << seed << " '"
                            << random.frame.resources()[barrier.resource].name << "' without "
                            << name(touch.access) << " of " << describe(all);
                    });
                    *side = all;
                }
            }
        }
    }
}

TEST(Hazards, EveryHandoverIsNeeded) {
    uint64_t removed = 0;
    for (uint64_t seed = 1; seed <= kFrames; ++seed) {
        const RandomFrame random(seed);
        const auto whole = compile(random.frame, {});
        ASSERT_TRUE(whole.ok());
        for (size_t step = 0; step < whole->steps.size(); ++step) {
            if (whole->steps[step].handover.handovers.empty()) continue;
            CompiledGraph broken = *whole;
            broken.steps[step].handover = {};
            ASSERT_FALSE(problems(random.frame, broken).empty())
                << "seed " << seed << " step " << step;
            ++removed;
        }
    }
    EXPECT_GT(removed, 100u);
}

TEST(Hazards, AnyLegalOrderGivesTheSameBytes) {
    for (uint64_t seed = 1; seed <= kFrames; ++seed) {
        const RandomFrame random(seed);
        const auto plain = compile(random.frame, {.alias = false});
        ASSERT_TRUE(plain.ok()) << plain.error().message;
        const auto expected = CpuExecutor(random.frame, *plain, 1).run();
        for (uint64_t order = 1; order <= 4; ++order) {
            const CompileOptions options{.randomOrderSeed = order * seed,
                                         .poisonTransients = order % 2 == 0};
            const auto graph = compile(random.frame, options);
            ASSERT_TRUE(graph.ok());
            ASSERT_EQ(CpuExecutor(random.frame, *graph, order + 7).run(), expected)
                << "seed " << seed << " order " << order;
        }
    }
}

/// Two lives laid over each other on purpose: the bytes must tell.
TEST(Hazards, WrongPlacesShowInTheBytes) {
    uint32_t told = 0;
    for (uint64_t seed = 1; seed <= 50; ++seed) {
        const RandomFrame random(seed);
        const auto graph = compile(random.frame, {.alias = false});
        ASSERT_TRUE(graph.ok());
        CompiledGraph broken = *graph;
        for (CompiledResource& resource : broken.resources) resource.offset = 0;
        const auto expected = CpuExecutor(random.frame, *graph, 1).run();
        told += CpuExecutor(random.frame, broken, 1).run() != expected ? 1 : 0;
    }
    EXPECT_GT(told, 30u);
}

}  // namespace
}  // namespace lampyris::graph
