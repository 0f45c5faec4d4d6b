#include "reference/warps.h"

#include "unit/reference/chi_squared.h"

namespace lampyris::reference {
namespace {

const glm::vec3 kAxis = glm::normalize(glm::vec3(0.3f, -0.8f, 0.5f));

TEST(Warps, FramesAreRightAngledForEveryNormal) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    std::vector<glm::vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1e-3f, 0, -1}};
    for (int i = 0; i < 1000; ++i)
        normals.emplace_back(normal(random), normal(random), normal(random));
    for (const glm::vec3& n : normals) {
        const Frame f(glm::normalize(n));
        EXPECT_NEAR(glm::dot(f.tangent, f.bitangent), 0.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(f.tangent, f.normal), 0.0f, 1e-5f);
        EXPECT_NEAR(glm::length(f.tangent), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(glm::cross(f.tangent, f.bitangent), f.normal), 1.0f, 1e-5f);
    }
}

TEST(Warps, CosineFollowsItsDensity) {
    expectDirectionsFollow(
        kAxis, [](glm::vec2 xi) { return warpToCosine(xi, kAxis); },
        [](const glm::vec3& w) { return std::max(glm::dot(w, kAxis), 0.0f) / math::kPi; });
}

TEST(Warps, SphereFollowsItsDensity) {
    expectDirectionsFollow(
        kAxis, [](glm::vec2 xi) { return warpToSphere(xi); },
        [](const glm::vec3&) { return 1.0f / (4.0f * math::kPi); });
}

TEST(Warps, ConeFollowsItsDensity) {
    const Frame frame(kAxis);
    for (const float height : {1.0f, 0.3f}) {
        expectDirectionsFollow(
            kAxis, [&](glm::vec2 xi) { return frame.toWorld(warpToCone(xi, height)); },
            [&](const glm::vec3& w) {
                return glm::dot(w, kAxis) > 1.0f - height ? 1.0f / (2.0f * math::kPi * height)
                                                          : 0.0f;
            });
    }
}

TEST(Warps, NarrowConesKeepTheirShape) {
    // 1 − cos here is below what a float's cosine can tell from 1.
    const float height = 1e-9f;
    double sum = 0.0;
    const int steps = 1000;
    for (int i = 0; i < steps; ++i) {
        const glm::vec3 w = warpToCone({(i + 0.5f) / steps, 0.25f}, height);
        sum += w.x * w.x + w.y * w.y;
    }
    EXPECT_NEAR(sum / steps, height, 1e-3 * height);  // the mean of sin² is half its largest
}

TEST(Warps, DiskAndTriangleAreUniform) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const uint32_t count = 100000;
    std::vector<double> disk(8 * 16, 0.0), triangle(10 * 10, 0.0);
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec2 p = warpToDisk({uniform(random), uniform(random)});
        const float r2 = std::min(glm::dot(p, p), 0.99999f);
        const float phi = std::atan2(p.y, p.x) / (2.0f * math::kPi) + 0.5f;
        ++disk[static_cast<size_t>(r2 * 8.0f) * 16 +
               std::min<size_t>(static_cast<size_t>(phi * 16.0f), 15)];
        // Back to the square by areas: of the strip towards the corner, and along it.
        const glm::vec2 uv = warpToTriangle({uniform(random), uniform(random)});
        const float strip = (uv.x + uv.y) * (uv.x + uv.y), along = uv.y / (uv.x + uv.y);
        ASSERT_GE(std::min(uv.x, uv.y), 0.0f);
        ASSERT_LE(uv.x + uv.y, 1.0f);
        ++triangle[std::min<size_t>(static_cast<size_t>(strip * 10.0f), 9) * 10 +
                   std::min<size_t>(static_cast<size_t>(along * 10.0f), 9)];
    }
    expectFollows(disk, std::vector<double>(disk.size(), count / double(disk.size())));
    expectFollows(triangle, std::vector<double>(triangle.size(), count / double(triangle.size())));
}

TEST(Warps, PowerHeuristicSharesAddUpToOne) {
    for (const float a : {1e-6f, 0.3f, 1.0f, 40.0f, 1e20f})
        for (const float b : {1e-6f, 0.2f, 1.0f, 1e6f, 1e20f})
            EXPECT_NEAR(powerHeuristic(a, b) + powerHeuristic(b, a), 1.0f, 1e-6f);
    EXPECT_EQ(powerHeuristic(0.0f, 0.0f), 0.0f);
    EXPECT_EQ(powerHeuristic(2.0f, 0.0f), 1.0f);
}

}  // namespace
}  // namespace lampyris::reference
