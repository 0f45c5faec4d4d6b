#include "courtyard/soak.h"

#include <gtest/gtest.h>

#include <set>

#include "courtyard/courtyard.h"
#include "unit/courtyard/world_facts.h"

namespace lampyris::courtyard {
namespace {

TEST(Soak, IsTheSameOnEveryRunAndDiffersBySeed) {
    const auto run = [](uint32_t seed) {
        ecs::World world = makeCourtyard();
        addSoak(world, seed);
        for (int i = 0; i < 300; ++i) test::advance(world, i / 30.0);
        return test::lookOf(world);
    };
    EXPECT_TRUE(run(7) == run(7));
    EXPECT_TRUE(run(7) != run(8));
}

TEST(Soak, TenThousandFramesLeaveNothingBehind) {
    ecs::World world = makeCourtyard();
    const size_t own = world.entityCount();
    const size_t meshes = world.resource<scene::Library>().meshes().size();
    addSoak(world, 1);
    size_t most = 0;
    std::set<size_t> lights;
    for (int i = 0; i < 10'000; ++i) {
        test::advance(world, i / 30.0);
        most = std::max(most, world.entityCount());
        lights.insert(world.count<scene::SphereLight>());
    }
    const size_t figures = kMostSoakFigures * 14;  // with their joints
    EXPECT_LE(most, own + kMostSoakThings + kMostSoakLights + figures + 40);
    EXPECT_LT(world.entities().back().index(), most + 40) << "slots are used again";
    EXPECT_EQ(world.resource<scene::Library>().meshes().size(), meshes);
    EXPECT_GE(*lights.begin(), 5u);
    EXPECT_LE(*lights.rbegin(), 6u + kMostSoakLights);
    EXPECT_GE(lights.size(), 3u);
}

}  // namespace
}  // namespace lampyris::courtyard
