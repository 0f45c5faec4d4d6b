#include "assets/triangulate.h"

#include <gtest/gtest.h>

namespace lampyris::assets {
namespace {

using Indices = std::vector<uint32_t>;

TEST(Triangulate, EveryOtherTriangleOfAStripIsTurned) {
    EXPECT_EQ(triangulate({0, 1, 2, 3, 4}, Topology::Strip), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
}

TEST(Triangulate, AFanTurnsAboutItsFirstVertex) {
    EXPECT_EQ(triangulate({7, 1, 2, 3}, Topology::Fan), (Indices{1, 2, 7, 2, 3, 7}));
}

TEST(Triangulate, AListLosesWhatIsLeftOver) {
    EXPECT_EQ(triangulate({0, 1, 2, 3, 4}, Topology::List), (Indices{0, 1, 2}));
}

TEST(Triangulate, TooFewIndicesAreNoTriangle) {
    for (const Topology topology : {Topology::List, Topology::Strip, Topology::Fan}) {
        EXPECT_TRUE(triangulate({}, topology).empty());
        EXPECT_TRUE(triangulate({0, 1}, topology).empty());
    }
}

}  // namespace
}  // namespace lampyris::assets
