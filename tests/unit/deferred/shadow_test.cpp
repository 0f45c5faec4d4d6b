#include "deferred/shadow.h"

#include <gtest/gtest.h>

namespace lampyris::deferred {
namespace {

TEST(ShadowCounts, TakeALayerForEachBitOf32Lights) {
    // The least that Vulkan guarantees: 256 layers. A share is five bits.
    EXPECT_TRUE(checkShadowCounts(0, 256).ok());
    EXPECT_TRUE(checkShadowCounts(1632, 256).ok());
    EXPECT_FALSE(checkShadowCounts(1633, 256).ok());
    EXPECT_TRUE(checkShadowCounts(13088, 2048).ok());
    EXPECT_FALSE(checkShadowCounts(13089, 2048).ok());
}

TEST(ShadowCounts, SayWhatDoesNotFit) {
    const std::string message = checkShadowCounts(3000, 256).error().message;
    for (const char* word : {"3000 lights", "maxImageArrayLayers, 256", "1632 lights"})
        EXPECT_NE(message.find(word), std::string::npos) << message;
}

}  // namespace
}  // namespace lampyris::deferred
