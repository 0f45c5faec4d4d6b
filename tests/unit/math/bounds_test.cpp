#include "math/bounds.h"

#include <gtest/gtest.h>

#include <random>

namespace lampyris::math {
namespace {

TEST(Bounds, StartsEmpty) {
    const Bounds bounds;
    EXPECT_TRUE(bounds.empty());
    EXPECT_EQ(bounds.extent(), glm::vec3(0.0f));
    EXPECT_EQ(bounds.halfArea(), 0.0f);
}

TEST(Bounds, GrowsByPointsAndBoxes) {
    Bounds bounds;
    bounds.grow(glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_FALSE(bounds.empty());
    EXPECT_EQ(bounds.lower, bounds.upper);
    bounds.grow(glm::vec3(-1.0f, 5.0f, 3.5f));
    EXPECT_EQ(bounds.extent(), glm::vec3(2.0f, 3.0f, 0.5f));
    EXPECT_EQ(bounds.centre(), glm::vec3(0.0f, 3.5f, 3.25f));
    EXPECT_FLOAT_EQ(bounds.halfArea(), 2.0f * 3.0f + 3.0f * 0.5f + 0.5f * 2.0f);
    const Bounds before = bounds;
    bounds.grow(Bounds{});
    EXPECT_EQ(bounds.lower, before.lower);
    EXPECT_EQ(bounds.upper, before.upper);
    bounds.grow(Bounds{glm::vec3(10.0f), glm::vec3(11.0f)});
    EXPECT_EQ(bounds.upper, glm::vec3(11.0f));
}

TEST(Bounds, TransformedHoldsEveryTransformedPoint) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const Bounds box{glm::vec3(-1.0f, 0.0f, -2.0f), glm::vec3(3.0f, 0.5f, 4.0f)};
    const glm::mat4 matrix =
        glm::translate(glm::mat4(1.0f), glm::vec3(5.0f, -2.0f, 1.0f)) *
        glm::rotate(glm::mat4(1.0f), 0.7f, glm::normalize(glm::vec3(1.0f, 2.0f, 3.0f))) *
        glm::scale(glm::mat4(1.0f), glm::vec3(2.0f, -1.0f, 0.5f));
    const Bounds around = transformed(box, matrix);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 at(unit(random), unit(random), unit(random));
        const glm::vec3 point = box.centre() + 0.5f * at * box.extent();
        const glm::vec3 moved = matrix * glm::vec4(point, 1.0f);
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(moved, around.lower - 1e-4f)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(moved, around.upper + 1e-4f)));
    }
    const Bounds shifted = transformed(box, glm::translate(glm::mat4(1.0f), glm::vec3(1.0f)));
    EXPECT_EQ(shifted.lower, box.lower + 1.0f) << "and is no larger than it must be";
    EXPECT_EQ(shifted.upper, box.upper + 1.0f);
    EXPECT_TRUE(transformed(Bounds{}, matrix).empty());
}

}  // namespace
}  // namespace lampyris::math
