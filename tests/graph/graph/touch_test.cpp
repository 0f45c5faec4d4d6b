#include "graph/touch.h"

#include <gtest/gtest.h>

namespace lampyris::graph {
namespace {

AccessSet setOf(std::initializer_list<Access> accesses) {
    AccessSet set;
    for (const Access access : accesses) set.add(access);
    return set;
}

TEST(Touch, SetsKeepKindAndAccessTogether) {
    TouchSet touches;
    EXPECT_TRUE(touches.empty());
    EXPECT_EQ(describe(touches), "nothing");
    touches.add({Access::Sampled, NodeKind::Compute});
    touches.add({Access::DepthRead, NodeKind::Raster});
    EXPECT_TRUE(touches.has({Access::Sampled, NodeKind::Compute}));
    EXPECT_FALSE(touches.has({Access::Sampled, NodeKind::Raster}));
    EXPECT_FALSE(touches.anyWrites());
    EXPECT_EQ(describe(touches), "compute Sampled + raster DepthRead");
    touches.add({Access::Present, NodeKind::Host});
    EXPECT_TRUE(touches.accesses().has(Access::Present));
}

TEST(Touch, EveryAccessReadsOrWrites) {
    for (uint32_t bit = 1; bit < kAccessCount; ++bit) {
        const auto access = static_cast<Access>(bit);
        EXPECT_TRUE(reads(access) || writes(access)) << name(access);
    }
    EXPECT_FALSE(reads(Access::None) || writes(Access::None));
    EXPECT_TRUE(reads(Access::StorageUpdate) && writes(Access::StorageUpdate));
}

TEST(Touch, LayoutsServeAllAccessesAtOnceOrNone) {
    const Format colour = Format::RGBA8Unorm;
    EXPECT_EQ(layoutFor(setOf({Access::Sampled}), colour), Layout::ReadOnly);
    EXPECT_EQ(layoutFor(setOf({Access::Sampled}), Format::D32Float), Layout::DepthReadOnly);
    EXPECT_EQ(layoutFor(setOf({Access::Sampled, Access::DepthRead}), Format::D32Float),
              Layout::DepthReadOnly);
    EXPECT_EQ(layoutFor(setOf({Access::StorageRead, Access::StorageWrite}), colour),
              Layout::General);
    EXPECT_FALSE(layoutFor(setOf({Access::Sampled, Access::StorageRead}), colour));
    EXPECT_FALSE(layoutFor(setOf({Access::DepthWrite, Access::DepthRead}), Format::D32Float));
    EXPECT_FALSE(layoutFor(setOf({Access::VertexRead}), colour));
}

TEST(Touch, TheWorldOutsideReadsInEveryKindOfShader) {
    EXPECT_EQ(describe(outsideTouches(Access::Sampled)), "compute Sampled + raster Sampled");
    EXPECT_EQ(describe(outsideTouches(Access::HostRead)), "host HostRead");
    EXPECT_TRUE(outsideTouches(Access::None).empty());
}

}  // namespace
}  // namespace lampyris::graph
