#include "scene/systems/animate.h"

#include <gtest/gtest.h>

#include "scene/library.h"
#include "scene/motion.h"
#include "scene/spawn.h"

namespace lampyris::scene {
namespace {

using assets::AnimatedProperty;
using assets::Interpolation;

/// Node 0 goes from 0 to (10, 0, 0) in two seconds, from second 1; node 1's weights to (1, 2).
assets::Animation moving() {
    assets::Animation clip;
    clip.name = "moving";
    clip.samplers = {{Interpolation::Linear, {1, 3}, 3, {0, 0, 0, 10, 0, 0}},
                     {Interpolation::Linear, {1, 3}, 2, {0, 0, 1, 2}}};
    clip.channels = {{0, 0, AnimatedProperty::Translation}, {1, 1, AnimatedProperty::Weights}};
    clip.durationSeconds = 3.0f;
    return clip;
}

class Animate : public testing::Test {
 protected:
    Animate() {
        world.setResource(Library{});
        moved = spawn(world, "moved");
        morphed = spawn(world, "morphed");
        world.add(morphed, MorphWeights{{0, 0}});
        player = spawn(world, "player");
        AnimationPlayer plays;
        plays.clip = world.resource<Library>().addClip(moving());
        plays.targets = {moved, morphed};
        world.add(player, plays);
    }
    float xAt(double seconds) {
        world.setResource(FrameTime{seconds, 0.0});
        animate(world);
        return world.get<Transform>(moved).translation.x;
    }
    AnimationPlayer& plays() { return world.edit<AnimationPlayer>(player); }

    ecs::World world;
    ecs::Entity moved, morphed, player;
};

TEST_F(Animate, PlacesTargetsByTheTimeAlone) {
    for (const double seconds : {2.0, 7.0, 1.5, -4.0, 2.0, 2.0, 1e9, 0.0}) {
        const double share = std::clamp((seconds - 1.0) / 2.0, 0.0, 1.0);
        EXPECT_FLOAT_EQ(xAt(seconds), static_cast<float>(10.0 * share)) << seconds;
        const auto& weights = world.get<MorphWeights>(morphed).values;
        EXPECT_FLOAT_EQ(weights[0], static_cast<float>(share));
        EXPECT_FLOAT_EQ(weights[1], static_cast<float>(2.0 * share));
    }
}

TEST_F(Animate, LoopsBothWays) {
    plays().loops = true;
    EXPECT_FLOAT_EQ(xAt(2.0), 5.0f);
    EXPECT_FLOAT_EQ(xAt(5.0), 5.0f);
    EXPECT_FLOAT_EQ(xAt(302.0), 5.0f);
    EXPECT_FLOAT_EQ(xAt(-1.0), 5.0f);
    EXPECT_FLOAT_EQ(xAt(-301.0), 5.0f);
    EXPECT_FLOAT_EQ(xAt(3.0), 0.0f);
}

TEST_F(Animate, StartsLaterFasterAndBackwards) {
    plays().startSeconds = 10.0;
    EXPECT_FLOAT_EQ(xAt(12.0), 5.0f);
    plays().speed = 2.0;
    EXPECT_FLOAT_EQ(xAt(11.0), 5.0f);
    plays().speed = -1.0;
    EXPECT_FLOAT_EQ(xAt(8.0), 5.0f);
    EXPECT_FLOAT_EQ(xAt(0.0), 10.0f);
}

TEST_F(Animate, OnlyWhatComesOutAnewIsChanged) {
    xAt(5.0);
    const ecs::Tick since = world.advance();
    xAt(6.0);
    EXPECT_TRUE(world.changedSince<Transform>(since).empty());
    EXPECT_TRUE(world.changedSince<MorphWeights>(since).empty());
    xAt(2.0);
    EXPECT_EQ(world.changedSince<Transform>(since), std::vector<ecs::Entity>{moved});
    EXPECT_EQ(world.changedSince<MorphWeights>(since), std::vector<ecs::Entity>{morphed});
}

TEST_F(Animate, PassesOverWhatIsGone) {
    world.destroy(moved);
    world.remove<MorphWeights>(morphed);
    world.setResource(FrameTime{2.0, 0.0});
    animate(world);
    EXPECT_FALSE(world.has<MorphWeights>(morphed));
    plays().targets = {};
    animate(world);
    plays().clip = ClipId{7};
    animate(world);
    plays().clip = {};
    animate(world);
}

TEST_F(Animate, NoTimeIsTimeZeroOfAFiniteWorld) {
    EXPECT_FLOAT_EQ(xAt(std::nan("")), 0.0f);
    plays().speed = std::numeric_limits<double>::infinity();
    EXPECT_FLOAT_EQ(xAt(0.0), 0.0f);
}

}  // namespace
}  // namespace lampyris::scene
