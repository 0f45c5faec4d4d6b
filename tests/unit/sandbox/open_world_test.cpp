#include "open_world.h"

#include <gtest/gtest.h>

#include "scene/components.h"
#include "scene/motion.h"

namespace lampyris::sandbox {
namespace {

TEST(OpenWorld, KnowsTheCourtyardAndPlacesItInTime) {
    Options options;
    options.scene = "courtyard";
    options.time = 2.5;
    const auto world = openWorld(options);
    ASSERT_TRUE(world.ok());
    EXPECT_EQ(world->resource<scene::FrameTime>().seconds, 2.5);
    EXPECT_GE(world->count<scene::SphereLight>(), 4u);
}

TEST(OpenWorld, AnUnknownNameIsAnErrorThatListsAllScenes) {
    Options options;
    options.scene = "courtyrad";
    const auto world = openWorld(options);
    ASSERT_FALSE(world.ok());
    for (const char* name : {"\"courtyrad\"", "courtyard", "cornell", "two_rooms"})
        EXPECT_NE(world.error().message.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace lampyris::sandbox
