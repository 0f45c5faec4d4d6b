#include "core/check.h"

#include <gtest/gtest.h>

#include <string>

namespace lampyris::core {
namespace {

enum class Colour { Red, Green };

TEST(Check, PassesQuietlyAndEvaluatesOnce) {
    int calls = 0;
    const auto next = [&] { return ++calls; };
    CHECK(next() == 1);
    CHECK(calls < 2);
    CHECK(calls > 0);
    CHECK(calls <= 1);
    CHECK(calls >= 1);
    CHECK(calls != 0);
    CHECK(calls);
    EXPECT_EQ(calls, 1);
}

TEST(CheckDeath, PrintsTheExpressionThePlaceAndBothValues) {
    const int three = 3;
    const int two = 2;
    EXPECT_DEATH(CHECK(three < two),
                 "CHECK\\(three < two\\) failed at .*check_test.cpp:[0-9]+: 3 < 2");
    EXPECT_DEATH(CHECK(three <= two), "3 <= 2");
    EXPECT_DEATH(CHECK(two > three), "2 > 3");
    EXPECT_DEATH(CHECK(two >= three), "2 >= 3");
    EXPECT_DEATH(CHECK(two == three), "2 == 3");
    EXPECT_DEATH(CHECK(two != 2), "2 != 2");
}

TEST(CheckDeath, PrintsWhatIsNoNumber) {
    const std::string name = "photon";
    const int* nowhere = nullptr;
    EXPECT_DEATH(CHECK(name == "path"), "photon == path");
    EXPECT_DEATH(CHECK(nowhere != nullptr), "CHECK\\(nowhere != nullptr\\)");
    EXPECT_DEATH(CHECK(Colour::Green == Colour::Red), "1 == 0");
    EXPECT_DEATH(CHECK(false), "CHECK\\(false\\) failed");
}

}  // namespace
}  // namespace lampyris::core
