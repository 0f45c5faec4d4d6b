#include "deferred/shadow.h"

#include <gtest/gtest.h>

namespace lampyris::deferred {
namespace {

TEST(ShadowCounts, TakeALayerForEachBitOf32Lights) {
    // The least that Vulkan guarantees: 256 layers. Eight rays are four bits.
    EXPECT_TRUE(checkShadowCounts(0, 8, 256).ok());
    EXPECT_TRUE(checkShadowCounts(2048, 8, 256).ok());
    EXPECT_FALSE(checkShadowCounts(2049, 8, 256).ok());
    EXPECT_TRUE(checkShadowCounts(8192, 1, 256).ok());
    EXPECT_FALSE(checkShadowCounts(8193, 1, 256).ok());
    EXPECT_TRUE(checkShadowCounts(1632, 31, 256).ok());
    EXPECT_FALSE(checkShadowCounts(1633, 31, 256).ok());
}

TEST(ShadowCounts, SayWhatDoesNotFit) {
    const std::string message = checkShadowCounts(3000, 8, 256).error().message;
    for (const char* word : {"3000 lights", "8 rays", "maxImageArrayLayers, 256", "2048 lights"})
        EXPECT_NE(message.find(word), std::string::npos) << message;
}

}  // namespace
}  // namespace lampyris::deferred
