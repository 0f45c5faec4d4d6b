#include "core/ids.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <unordered_set>

namespace lampyris::core {
namespace {

using AppleId = Id<struct AppleTag>;
using PearId = Id<struct PearTag>;

static_assert(!std::is_convertible_v<AppleId, PearId> && !std::is_constructible_v<AppleId, PearId>);
static_assert(sizeof(AppleId) == 4);

TEST(Ids, AreNoneUntilGiven) {
    EXPECT_FALSE(AppleId{}.valid());
    EXPECT_TRUE(AppleId{0}.valid());
    EXPECT_LT(AppleId{1}, AppleId{2});
    EXPECT_EQ((std::unordered_set<AppleId>{AppleId{1}, AppleId{1}, AppleId{2}}.size()), 2u);
}

}  // namespace
}  // namespace lampyris::core
