#include "core/log.h"

#include <gtest/gtest.h>

namespace lampyris::core {
namespace {

TEST(Log, WritesOneLineAMessageToStderr) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    logInfo("{} photons", 3);
    logWarning("low");
    logError("broken: {}", "x");
    logDebug("unseen");
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "3 photons\nwarning: low\nerror: broken: x\n");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Log, DropsWhatIsUnderTheLevel) {
    testing::internal::CaptureStderr();
    setLogLevel(LogLevel::Error);
    logWarning("unseen");
    setLogLevel(LogLevel::Debug);
    logDebug("seen");
    setLogLevel(LogLevel::Info);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "seen\n");
}

TEST(Log, PrintsBracesOfAMessageAsTheyAre) {
    testing::internal::CaptureStderr();
    logInfo("{}", "{\"json\": {}}");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "{\"json\": {}}\n");
}

TEST(Log, KeepsLinesBackUntilTheyAreReleasedOrTaken) {
    testing::internal::CaptureStderr();
    holdLog();
    logWarning("first");
    logInfo("second");
    logDebug("unseen");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    testing::internal::CaptureStderr();
    releaseLog();
    logInfo("third");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: first\nsecond\nthird\n");
    testing::internal::CaptureStderr();
    holdLog();
    logWarning("fourth");
    EXPECT_EQ(takeHeldLog(), std::vector<std::string>{"fourth"});
    releaseLog();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace lampyris::core
