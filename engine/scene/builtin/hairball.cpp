#include "scene/builtin/hairball.h"

#include <array>

#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::scene::builtin {

namespace {

constexpr uint32_t kStrands = 2000;
constexpr uint32_t kPieces = 180;
constexpr uint32_t kSides = 4;

glm::vec3 randomVector(uint32_t seed, uint32_t counter) {
    return {hashSigned(seed, 3 * counter), hashSigned(seed, 3 * counter + 1),
            hashSigned(seed, 3 * counter + 2)};
}

/// A curl in the unit ball: the direction turns about an axis that itself wanders, and is drawn
/// back to the middle outside of kFree.
std::array<glm::vec3, kPieces + 1> strandPath(uint32_t strand) {
    constexpr float kStep = 0.033f;  // of the ball's radius
    constexpr float kTurn = 0.16f;   // radians a step, roughly
    constexpr float kWander = 0.12f;
    constexpr float kFree = 0.68f;
    constexpr float kReach = 1.04f;  // no tube comes further from the middle [measured: 1.033]
    std::array<glm::vec3, kPieces + 1> path;
    glm::vec3 direction = glm::normalize(randomVector(strand, 0) + glm::vec3(1e-3f));
    glm::vec3 axis = randomVector(strand, 1);
    glm::vec3 position = 0.1f * randomVector(strand, 2);
    for (uint32_t i = 0; i <= kPieces; ++i) {
        path[i] = position / kReach;
        axis = glm::normalize(axis + kWander * randomVector(strand, 3 + i));
        direction += kTurn * glm::cross(axis, direction);
        const float distance = glm::length(position);
        if (distance > kFree) direction -= (distance - kFree) * 2.1f * position;
        direction = glm::normalize(direction);
        position += kStep * direction;
    }
    return path;
}

}  // namespace

assets::Mesh makeHairball(float radiusMetres) {
    assets::Mesh mesh;
    mesh.name = "hairball";
    mesh.positions.reserve(size_t{kStrands} * (kPieces + 1) * kSides);
    mesh.normals.reserve(size_t{kStrands} * (kPieces + 1) * kSides);
    mesh.indices.reserve(size_t{kStrands} * kPieces * kSides * 6);
    for (uint32_t strand = 0; strand < kStrands; ++strand) {
        auto path = strandPath(strand);
        for (glm::vec3& p : path) p *= radiusMetres;
        const float thickness = 0.003f + 0.003f * hashUnit(strand, 0xfffffu);
        addTube(mesh, path, thickness * radiusMetres, kSides);
    }
    assets::updateBounds(mesh);
    return mesh;
}

}  // namespace lampyris::scene::builtin
