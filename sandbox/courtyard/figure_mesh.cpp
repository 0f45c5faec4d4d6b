// The figure's skin: tubes of many rings, each ring weighted between the two joints it lies by.
#include <array>
#include <span>

#include "courtyard/figure.h"
#include "courtyard/forms.h"
#include "scene/builtin/numbers.h"

namespace lampyris::courtyard {
namespace {

/// A station of a limb: the tube runs smoothly from one to the next.
struct Station {
    glm::vec3 centre;
    glm::vec2 radius;  ///< along x and z of the ring
};

/// Where a limb bends: vertices before it follow one joint, those behind it the next.
struct Bend {
    float at;      ///< share of the limb's stations
    float spread;  ///< half the blend
};

struct Limb {
    std::span<const Station> stations;
    std::span<const Joint> joints;
    std::span<const Bend> bends;  ///< one fewer than joints
    uint32_t sides = 20;
    uint32_t rings = 30;
};

Station between(std::span<const Station> stations, float share) {
    const float at = share * static_cast<float>(stations.size() - 1);
    const size_t piece = glm::min(static_cast<size_t>(at), stations.size() - 2);
    const float t = at - static_cast<float>(piece);
    return {glm::mix(stations[piece].centre, stations[piece + 1].centre, t),
            glm::mix(stations[piece].radius, stations[piece + 1].radius, t)};
}

/// The joints at a share of the limb, and how much the second has of it.
void addWeights(assets::Mesh& mesh, const Limb& limb, float share) {
    size_t first = 0;
    while (first < limb.bends.size() && share > limb.bends[first].at + limb.bends[first].spread)
        ++first;
    const bool last = first == limb.bends.size();
    const Joint joint = limb.joints[first];
    const Joint next = last ? joint : limb.joints[first + 1];
    float second = 0.0f;
    if (!last) {
        const Bend& bend = limb.bends[first];
        second = glm::smoothstep(bend.at - bend.spread, bend.at + bend.spread, share);
    }
    mesh.joints.emplace_back(joint, next, 0, 0);
    mesh.weights.emplace_back(1.0f - second, second, 0.0f, 0.0f);
}

/// Rings from the top station down; its ends are closed by a ring too small to be seen.
void addLimb(assets::Mesh& mesh, const Limb& limb) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t ring = 0; ring < limb.rings; ++ring) {
        const float share = static_cast<float>(ring) / static_cast<float>(limb.rings - 1);
        const Station station = between(limb.stations, share);
        for (uint32_t side = 0; side < limb.sides; ++side) {
            const auto angle = scene::builtin::sinCosTurns(static_cast<double>(side) / limb.sides);
            mesh.positions.push_back(
                station.centre + glm::vec3(station.radius.x * static_cast<float>(angle.cos), 0.0f,
                                           station.radius.y * static_cast<float>(angle.sin)));
            addWeights(mesh, limb, share);
        }
    }
    addGrid(mesh, first, limb.sides, limb.rings, true);
    smoothNormals(mesh, first);
}

void addLeg(assets::Mesh& mesh, float side, const std::array<Joint, 3>& joints) {
    const float x = 0.1f * side;
    const std::array<Station, 9> stations{{{{x, 0.93f, 0.0f}, {0.08f, 0.09f}},
                                           {{x, 0.8f, 0.0f}, {0.085f, 0.095f}},
                                           {{x, 0.62f, 0.0f}, {0.07f, 0.078f}},
                                           {{x, 0.46f, 0.005f}, {0.056f, 0.06f}},
                                           {{x, 0.3f, -0.01f}, {0.055f, 0.062f}},
                                           {{x, 0.14f, 0.0f}, {0.042f, 0.046f}},
                                           {{x, 0.07f, 0.03f}, {0.05f, 0.09f}},
                                           {{x, 0.02f, 0.05f}, {0.052f, 0.125f}},
                                           {{x, 0.0f, 0.05f}, {0.002f, 0.002f}}}};
    const std::array<Bend, 2> bends{{{0.375f, 0.07f}, {0.68f, 0.06f}}};
    addLimb(mesh, {stations, joints, bends, 16, 33});
}

void addArm(assets::Mesh& mesh, float side, const std::array<Joint, 3>& joints) {
    const float x = 0.2f * side;
    const std::array<Station, 9> stations{{{{0.13f * side, 1.47f, 0.0f}, {0.002f, 0.002f}},
                                           {{0.165f * side, 1.43f, 0.0f}, {0.06f, 0.06f}},
                                           {{x, 1.36f, 0.0f}, {0.058f, 0.058f}},
                                           {{x * 1.1f, 1.24f, 0.0f}, {0.048f, 0.05f}},
                                           {{x * 1.15f, 1.12f, 0.0f}, {0.042f, 0.044f}},
                                           {{x * 1.18f, 1.0f, 0.01f}, {0.038f, 0.04f}},
                                           {{x * 1.2f, 0.88f, 0.02f}, {0.032f, 0.034f}},
                                           {{x * 1.2f, 0.8f, 0.025f}, {0.028f, 0.046f}},
                                           {{x * 1.2f, 0.74f, 0.03f}, {0.002f, 0.002f}}}};
    const std::array<Bend, 2> bends{{{0.14f, 0.1f}, {0.5f, 0.07f}}};
    addLimb(mesh, {stations, joints, bends, 14, 31});
}

void addTorso(assets::Mesh& mesh) {
    const std::array<Station, 10> stations{{{{0.0f, 1.52f, 0.0f}, {0.002f, 0.002f}},
                                            {{0.0f, 1.5f, 0.0f}, {0.075f, 0.07f}},
                                            {{0.0f, 1.44f, 0.0f}, {0.17f, 0.1f}},
                                            {{0.0f, 1.32f, 0.005f}, {0.18f, 0.125f}},
                                            {{0.0f, 1.2f, 0.0f}, {0.155f, 0.115f}},
                                            {{0.0f, 1.06f, 0.0f}, {0.145f, 0.11f}},
                                            {{0.0f, 0.94f, 0.0f}, {0.18f, 0.14f}},
                                            {{0.0f, 0.82f, 0.0f}, {0.205f, 0.165f}},
                                            {{0.0f, 0.7f, 0.0f}, {0.23f, 0.19f}},
                                            {{0.0f, 0.7f, 0.0f}, {0.002f, 0.002f}}}};
    const std::array<Joint, 2> joints{kChest, kHips};
    const std::array<Bend, 1> bends{{{0.5f, 0.12f}}};
    addLimb(mesh, {stations, joints, bends, 28, 40});
}

void addHead(assets::Mesh& mesh) {
    const std::array<Station, 11> stations{{{{0.0f, 1.8f, -0.02f}, {0.002f, 0.002f}},
                                            {{0.0f, 1.78f, -0.015f}, {0.05f, 0.055f}},
                                            {{0.0f, 1.745f, -0.005f}, {0.075f, 0.09f}},
                                            {{0.0f, 1.72f, 0.0f}, {0.16f, 0.17f}},
                                            {{0.0f, 1.705f, 0.0f}, {0.165f, 0.175f}},
                                            {{0.0f, 1.7f, 0.005f}, {0.082f, 0.1f}},
                                            {{0.0f, 1.65f, 0.01f}, {0.082f, 0.1f}},
                                            {{0.0f, 1.6f, 0.015f}, {0.068f, 0.085f}},
                                            {{0.0f, 1.56f, 0.01f}, {0.05f, 0.055f}},
                                            {{0.0f, 1.5f, 0.0f}, {0.05f, 0.05f}},
                                            {{0.0f, 1.46f, 0.0f}, {0.06f, 0.06f}}}};
    const std::array<Joint, 2> joints{kHead, kChest};
    const std::array<Bend, 1> bends{{{0.87f, 0.08f}}};
    addLimb(mesh, {stations, joints, bends, 24, 41});
}

}  // namespace

assets::Mesh makeFigureMesh() {
    assets::Mesh mesh;
    mesh.name = "figure";
    addTorso(mesh);
    addHead(mesh);
    addArm(mesh, 1.0f, {kChest, kLeftArm, kLeftForearm});
    addArm(mesh, -1.0f, {kChest, kRightArm, kRightForearm});
    addLeg(mesh, 1.0f, {kLeftThigh, kLeftShin, kLeftFoot});
    addLeg(mesh, -1.0f, {kRightThigh, kRightShin, kRightFoot});
    assets::updateBounds(mesh);
    return mesh;
}

}  // namespace lampyris::courtyard
