#include "math/glm.h"

#include <gtest/gtest.h>

namespace lampyris::math {
namespace {

glm::vec3 project(const glm::mat4& matrix, const glm::vec3& point) {
    const glm::vec4 clip = matrix * glm::vec4(point, 1.0f);
    return glm::vec3(clip) / clip.w;
}

class Perspective : public testing::Test {
 protected:
    const float aspect = 16.0f / 9.0f;
    const float halfHeight = std::tan(0.35f);  // at 1 m
    const glm::mat4 matrix = perspectiveReversed(0.7f, aspect, 0.25f);
};

TEST_F(Perspective, DepthIsOneAtTheNearPlaneAndFallsToZero) {
    EXPECT_NEAR(project(matrix, {0.0f, 0.0f, -0.25f}).z, 1.0f, 1e-6f);
    EXPECT_NEAR(project(matrix, {0.0f, 0.0f, -0.5f}).z, 0.5f, 1e-6f);
    EXPECT_NEAR(project(matrix, {3.0f, -2.0f, -1e6f}).z, 0.0f, 1e-6f);
    EXPECT_GT((matrix * glm::vec4(0.0f, 0.0f, -1.0f, 1.0f)).w, 0.0f) << "in front of the camera";
}

TEST_F(Perspective, TheEdgesOfTheFieldAreTheEdgesOfTheImage) {
    for (const float distance : {0.3f, 1.0f, 40.0f}) {
        const float top = halfHeight * distance;
        EXPECT_NEAR(project(matrix, {0.0f, top, -distance}).y, -1.0f, 1e-5f)
            << "up is the image's top row";
        EXPECT_NEAR(project(matrix, {0.0f, -top, -distance}).y, 1.0f, 1e-5f);
        EXPECT_NEAR(project(matrix, {aspect * top, 0.0f, -distance}).x, 1.0f, 1e-5f);
        EXPECT_NEAR(project(matrix, {-aspect * top, 0.0f, -distance}).x, -1.0f, 1e-5f);
    }
}

TEST(Glm, IsCompiledAsTheProjectUsesIt) {
    const glm::mat4 glmsOwn = glm::perspective(1.0f, 1.0f, 1.0f, 10.0f);
    EXPECT_NEAR(project(glmsOwn, {0.0f, 0.0f, -1.0f}).z, 0.0f, 1e-6f)
        << "clip depth starts at 0, not at -1";
    const glm::quat turn = glm::angleAxis(kPi / 2.0f, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_NEAR((turn * glm::vec3(1.0f, 0.0f, 0.0f)).z, -1.0f, 1e-6f) << "right-handed, radians";
}

}  // namespace
}  // namespace lampyris::math
