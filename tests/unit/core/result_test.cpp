#include "core/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace lampyris::core {
namespace {

Result<int> half(int value) {
    if (value % 2 != 0) return error("{} is odd", value);
    return value / 2;
}

Result<int> quarter(int value) {
    TRY(const int once, half(value));
    TRY(const int twice, half(once));
    return twice;
}

Result<void> demandEven(int value) {
    TRY_VOID(half(value).ok() ? Result<void>() : Result<void>(error("no")));
    return {};
}

TEST(Result, HoldsAValueOrAnError) {
    const Result<int> good = half(8);
    ASSERT_TRUE(good.ok());
    EXPECT_TRUE(static_cast<bool>(good));
    EXPECT_EQ(*good, 4);
    const Result<int> bad = half(7);
    ASSERT_FALSE(bad.ok());
    EXPECT_EQ(bad.error().message, "7 is odd");
}

TEST(Result, TryGoesOnOrHandsTheErrorBack) {
    EXPECT_EQ(quarter(12).value(), 3);
    EXPECT_EQ(quarter(7).error().message, "7 is odd");
    EXPECT_EQ(quarter(6).error().message, "3 is odd");
}

TEST(Result, WorksWithoutAValue) {
    EXPECT_TRUE(demandEven(2).ok());
    EXPECT_EQ(demandEven(1).error().message, "no");
}

TEST(Result, MovesItsValueOut) {
    Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
    const std::unique_ptr<int> taken = std::move(result).value();
    EXPECT_EQ(*taken, 5);
}

}  // namespace
}  // namespace lampyris::core
