#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/pose.h"

namespace lampyris::scene {

namespace {

/// In double: what floats multiply to stays in range.
struct Box {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};
};

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isFinite(const Box& box) {
    const glm::dvec3 sum = box.lower + box.upper;
    return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

/// All offsets that the weighted morph targets may add.
Box morphed(const PoseExtents& extents, const Pose& pose) {
    Box sum{glm::dvec3(0.0), glm::dvec3(0.0)};
    const size_t targets = std::min(extents.offsets.size(), pose.morphWeights.size());
    for (size_t t = 0; t < targets; ++t) {
        const auto weight = static_cast<double>(pose.morphWeights[t]);
        if (weight == 0.0) continue;
        const glm::dvec3 a = weight * glm::dvec3(extents.offsets[t].lower);
        const glm::dvec3 b = weight * glm::dvec3(extents.offsets[t].upper);
        sum.lower += glm::min(a, b);
        sum.upper += glm::max(a, b);
    }
    return sum;
}

/// Grows `box` by the transformed `of`, and `reach` to the sums of magnitudes behind its numbers.
void growByTransformed(Box& box, glm::dvec3& reach, const Box& of, const glm::mat4& matrix) {
    const glm::dvec3 largest = glm::max(glm::abs(of.lower), glm::abs(of.upper));
    Box moved{glm::dvec3(matrix[3]), glm::dvec3(matrix[3])};
    glm::dvec3 magnitude = glm::abs(glm::dvec3(matrix[3]));
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 column(matrix[i]);
        moved.lower += glm::min(column * of.lower[i], column * of.upper[i]);
        moved.upper += glm::max(column * of.lower[i], column * of.upper[i]);
        magnitude += glm::abs(column) * largest[i];
    }
    if (!isFinite(moved)) return;  // no vertex that follows such a joint is finite
    box.lower = glm::min(box.lower, moved.lower);
    box.upper = glm::max(box.upper, moved.upper);
    reach = glm::max(reach, magnitude);
}

/// As floats, wider by what vertices computed in float may miss.
math::Bounds rounded(const Box& box, const glm::dvec3& reach) {
    constexpr double kRounding = 32.0 * 5.96e-8;  // some thirty roundings lie behind a vertex
    const glm::dvec3 most(static_cast<double>(std::numeric_limits<float>::max()));
    return {glm::vec3(glm::clamp(box.lower - kRounding * reach, -most, most)),
            glm::vec3(glm::clamp(box.upper + kRounding * reach, -most, most))};
}

}  // namespace

PoseExtents poseExtents(const assets::Mesh& mesh) {
    PoseExtents extents;
    for (const glm::vec3& position : mesh.positions) extents.rest.grow(position);
    for (size_t i = 0; i < mesh.joints.size(); ++i) {
        for (int k = 0; k < 4; ++k) {
            if (mesh.weights[i][k] == 0.0f) continue;
            const size_t joint = mesh.joints[i][k];
            if (joint >= extents.joints.size()) extents.joints.resize(joint + 1);
            extents.joints[joint].grow(mesh.positions[i]);
        }
    }
    for (const assets::MorphTarget& target : mesh.morphTargets) {
        math::Bounds& offset = extents.offsets.emplace_back();
        offset.grow(glm::vec3(0.0f));
        for (const glm::vec3& position : target.positions)
            if (isFinite(position)) offset.grow(position);
    }
    return extents;
}

math::Bounds posedBounds(const PoseExtents& extents, const Pose& pose) {
    const Box offsets = morphed(extents, pose);
    Box box;
    glm::dvec3 reach(0.0);
    const auto grow = [&](const math::Bounds& part, const glm::mat4& matrix) {
        if (part.empty()) return;
        growByTransformed(
            box, reach,
            {glm::dvec3(part.lower) + offsets.lower, glm::dvec3(part.upper) + offsets.upper},
            matrix);
    };
    if (pose.jointMatrices.empty() || extents.joints.empty()) grow(extents.rest, glm::mat4(1.0f));
    const size_t joints = std::min(extents.joints.size(), pose.jointMatrices.size());
    for (size_t j = 0; j < joints; ++j) grow(extents.joints[j], pose.jointMatrices[j]);
    // Nothing finite is left to hold: the mesh at rest stands in.
    return box.lower.x <= box.upper.x ? rounded(box, reach) : extents.rest;
}

math::Bounds posedBounds(const assets::Mesh& mesh, const Pose& pose) {
    return posedBounds(poseExtents(mesh), pose);
}

}  // namespace lampyris::scene
