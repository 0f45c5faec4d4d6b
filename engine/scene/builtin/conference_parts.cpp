#include "scene/builtin/conference_parts.h"

#include <array>

#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::scene::builtin {

namespace {

glm::mat4 moved(const glm::mat4& placement, const glm::vec3& offset) {
    return glm::translate(placement, offset);
}

glm::vec3 pointOf(const glm::mat4& placement, const glm::vec3& point) {
    return {placement * glm::vec4(point, 1.0f)};
}

/// Points on a quadratic curve from a to c, drawn towards b.
template <size_t kCount>
std::array<glm::vec3, kCount> curve(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    std::array<glm::vec3, kCount> points;
    for (size_t i = 0; i < kCount; ++i) {
        const float t = static_cast<float>(i) / (kCount - 1);
        points[i] = (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
    }
    return points;
}

}  // namespace

void addChairCushions(assets::Mesh& mesh, const glm::mat4& placement) {
    addRoundedBox(mesh, moved(placement, {0.0f, 0.47f, 0.0f}),
                  {{0.25f, 0.05f, 0.25f}, 0.045f, 5, 4});
    addRoundedBox(mesh, moved(placement, {0.0f, 0.86f, -0.24f}),
                  {{0.23f, 0.3f, 0.04f}, 0.038f, 5, 4});
}

void addChairFrame(assets::Mesh& mesh, const glm::mat4& placement) {
    addCylinder(mesh, moved(placement, {0.0f, 0.1f, 0.0f}), 0.03f, 0.33f, 24);
    for (uint32_t i = 0; i < 5; ++i) {
        const SinCos angle = sinCosTurns(0.2 * i);
        const glm::vec3 out(static_cast<float>(angle.cos), 0.0f, static_cast<float>(angle.sin));
        const glm::vec3 castor = 0.28f * out + glm::vec3(0.0f, 0.035f, 0.0f);
        const auto leg = curve<13>(pointOf(placement, {0.0f, 0.13f, 0.0f}),
                                   pointOf(placement, 0.2f * out + glm::vec3(0.0f, 0.12f, 0.0f)),
                                   pointOf(placement, castor));
        addTube(mesh, leg, 0.018f, 8);
        addSphere(mesh, pointOf(placement, castor), 0.034f, 6);
    }
    for (const float side : {-1.0f, 1.0f}) {
        const auto arm = curve<21>(pointOf(placement, {0.24f * side, 0.48f, 0.12f}),
                                   pointOf(placement, {0.38f * side, 0.85f, 0.2f}),
                                   pointOf(placement, {0.22f * side, 0.72f, -0.24f}));
        addTube(mesh, arm, 0.016f, 10);
    }
}

void addCup(assets::Mesh& mesh, const glm::mat4& placement) {
    addCylinder(mesh, placement, 0.04f, 0.09f, 48);
    const glm::vec3 side(0.06f, 0.045f, 0.0f);
    const glm::mat4 upright = glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, 1, 0),
                                        glm::vec4(0, -1, 0, 0), glm::vec4(side, 1.0f));
    addTorus(mesh, placement * upright, 0.028f, 0.006f, 24, 12);
}

void addLampRing(assets::Mesh& mesh, const glm::vec3& centre, float ceilingY) {
    constexpr float kRingRadius = 0.34f;
    addTorus(mesh, placed(centre), kRingRadius, 0.03f, 96, 32);
    for (uint32_t i = 0; i < 3; ++i) {
        const SinCos angle = sinCosTurns(i / 3.0);
        const glm::vec3 offset(kRingRadius * static_cast<float>(angle.cos), 0.0f,
                               kRingRadius * static_cast<float>(angle.sin));
        addCylinder(mesh, placed(centre + offset), 0.006f, ceilingY - centre.y, 12);
    }
}

void addBlind(assets::Mesh& mesh, const glm::vec3& topLeft, const glm::vec2& size) {
    constexpr int kSlats = 24;
    for (int i = 0; i < kSlats; ++i) {
        const float down = size.y * (static_cast<float>(i) + 0.5f) / kSlats;
        const glm::vec3 centre = topLeft + glm::vec3(0.5f * size.x, -down, 0.0f);
        addRoundedBox(mesh, placed(centre), {{0.49f * size.x, 0.004f, 0.022f}, 0.0035f, 1, 1});
    }
}

void addCurtain(assets::Mesh& mesh, const glm::vec3& top, const glm::vec2& size) {
    constexpr uint32_t kColumns = 120;
    constexpr uint32_t kRows = 36;
    constexpr double kFolds = 9.0;
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t row = 0; row <= kRows; ++row) {
        const float down = size.y * static_cast<float>(row) / kRows;
        const float depth = 0.05f + 0.02f * static_cast<float>(row) / kRows;
        for (uint32_t column = 0; column <= kColumns; ++column) {
            const double along = static_cast<double>(column) / kColumns;
            const SinCos fold = sinCosTurns(kFolds * along);
            const float slope =
                depth * static_cast<float>(kFolds * 6.283185307179586 * fold.cos) / size.x;
            mesh.positions.push_back(top + glm::vec3(size.x * static_cast<float>(along), -down,
                                                     depth * static_cast<float>(fold.sin)));
            mesh.normals.push_back(glm::normalize(glm::vec3(-slope, 0.0f, 1.0f)));
        }
    }
    for (uint32_t row = 0; row < kRows; ++row) {
        for (uint32_t column = 0; column < kColumns; ++column) {
            const uint32_t a = first + row * (kColumns + 1) + column;
            const uint32_t below = a + kColumns + 1;
            mesh.indices.insert(mesh.indices.end(), {a, below, below + 1, a, below + 1, a + 1});
        }
    }
}

void addLeaves(assets::Mesh& mesh, const glm::vec3& foot, uint32_t seed) {
    for (uint32_t leaf = 0; leaf < 40; ++leaf) {
        const SinCos angle = sinCosTurns(hashUnit(seed, 4 * leaf));
        const glm::vec3 out(static_cast<float>(angle.cos), 0.0f, static_cast<float>(angle.sin));
        const float length = 0.35f + 0.25f * hashUnit(seed, 4 * leaf + 1);
        const float height = 0.7f + 0.6f * hashUnit(seed, 4 * leaf + 2);
        const auto rib =
            curve<17>(foot + 0.02f * out, foot + 0.2f * length * out + glm::vec3(0, height, 0),
                      foot + length * out + glm::vec3(0.0f, 0.6f * height, 0.0f));
        addTube(mesh, rib, 0.012f, 6);
    }
}

}  // namespace lampyris::scene::builtin
