#include "fly_camera.h"

#include <gtest/gtest.h>

namespace lampyris::sandbox {
namespace {

window::Input holding(unsigned char key) {
    window::Input input;
    input.held[key] = true;
    return input;
}

void expectNear(const glm::vec3& a, const glm::vec3& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-5f);
}

TEST(FlyCamera, KeysMoveAlongItsOwnAxes) {
    // Looks along +x.
    const glm::mat4 camera =
        glm::inverse(glm::lookAt(glm::vec3(1, 2, 3), glm::vec3(2, 2, 3), glm::vec3(0, 1, 0)));
    const auto after = [&](unsigned char key) {
        return glm::vec3(fly(camera, holding(key), 4.0f, 0.5f)[3]);
    };
    expectNear(after('W'), {3, 2, 3});
    expectNear(after('S'), {-1, 2, 3});
    expectNear(after('D'), {1, 2, 5});
    expectNear(after('A'), {1, 2, 1});
    expectNear(after('E'), {1, 4, 3});
    expectNear(after('Q'), {1, 0, 3});
    expectNear(after('X'), {1, 2, 3});
}

TEST(FlyCamera, DraggingTurnsItAndItStaysUpright) {
    window::Input input;
    input.movedX = 100.0;
    EXPECT_EQ(fly(glm::mat4(1.0f), input, 1.0f, 1.0f), glm::mat4(1.0f)) << "no button is held";
    input.buttons[0] = true;
    const glm::mat4 right = fly(glm::mat4(1.0f), input, 1.0f, 1.0f);
    EXPECT_GT(-right[2].x, 0.1f) << "looks to the right";
    EXPECT_NEAR(right[0].y, 0.0f, 1e-5f);
    input.movedX = 0.0;
    input.movedY = 20.0;
    glm::mat4 down(1.0f);
    for (int i = 0; i < 100; ++i) down = fly(down, input, 1.0f, 1.0f);
    EXPECT_LT(-down[2].y, -0.9f) << "looks down";
    EXPECT_GT(down[1].y, 0.0f) << "and not over";
    expectNear(glm::cross(glm::vec3(down[0]), glm::vec3(down[1])), glm::vec3(down[2]));
}

TEST(FlyCamera, StaysRigidHoweverOftenItTurns) {
    window::Input input;
    input.buttons[0] = true;
    glm::mat4 camera(1.0f);
    for (int i = 0; i < 200'000; ++i) {
        input.movedX = 7.0 + i % 5;
        input.movedY = i % 200 < 100 ? 3.0 : -3.0;
        camera = fly(camera, input, 1.0f, 0.0f);
    }
    const glm::mat3 axes(camera);
    const glm::mat3 gram = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i) expectNear(gram[i], glm::mat3(1.0f)[i]);
    EXPECT_GT(glm::determinant(axes), 0.0f);
    input.movedX = input.movedY = 0.0;
    EXPECT_EQ(fly(camera, input, 1.0f, 1.0f), camera) << "held and still";
}

}  // namespace
}  // namespace lampyris::sandbox
