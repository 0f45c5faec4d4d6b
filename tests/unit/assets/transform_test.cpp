#include "assets/transform.h"

#include <gtest/gtest.h>

#include <random>

namespace lampyris::assets {
namespace {

glm::dmat4 compose(const DecomposedMatrix& parts) {
    return glm::translate(glm::dmat4(1.0), glm::dvec3(parts.translation)) *
           glm::mat4_cast(glm::dquat(parts.rotation)) *
           glm::scale(glm::dmat4(1.0), glm::dvec3(parts.scale));
}

void expectComposesTo(const glm::dmat4& matrix) {
    const DecomposedMatrix parts = decompose(matrix);
    EXPECT_FALSE(parts.sheared);
    const glm::dmat4 again = compose(parts);
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(again[i / 4][i % 4], matrix[i / 4][i % 4], 1e-4) << i;
}

TEST(Transform, WhatWasComposedComesApart) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> number(-2.0f, 2.0f);
    for (int i = 0; i < 200; ++i) {
        DecomposedMatrix parts;
        parts.translation = {number(random), number(random), number(random)};
        parts.rotation = glm::normalize(
            glm::quat(number(random), number(random), number(random), number(random)));
        parts.scale = {number(random), number(random), number(random)};
        expectComposesTo(compose(parts));
    }
}

TEST(Transform, MirrorsHaveOneNegativeScale) {
    const DecomposedMatrix parts = decompose(glm::scale(glm::dmat4(1.0), glm::dvec3(1, -2, 3)));
    EXPECT_LT(parts.scale.x * parts.scale.y * parts.scale.z, 0.0f);
}

TEST(Transform, AxesOfScaleZeroLeaveARotation) {
    for (const glm::dvec3 scale : {glm::dvec3(0, 1, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 0)}) {
        const glm::dmat4 matrix = glm::scale(glm::dmat4(1.0), scale);
        expectComposesTo(matrix);
        EXPECT_NEAR(glm::length(decompose(matrix).rotation), 1.0f, 1e-6f);
    }
}

TEST(Transform, ShearIsSeen) {
    glm::dmat4 matrix(1.0);
    matrix[1][0] = 0.5;
    EXPECT_TRUE(decompose(matrix).sheared);
}

}  // namespace
}  // namespace lampyris::assets
