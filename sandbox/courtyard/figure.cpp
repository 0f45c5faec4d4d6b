#include "courtyard/figure.h"

#include <array>

#include "core/check.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/movements.h"
#include "scene/builtin/numbers.h"

namespace lampyris::courtyard {
namespace {

constexpr std::array<JointRest, kJointCount> kRest{{{kHips, {0.0f, 0.95f, 0.0f}},
                                                    {kHips, {0.0f, 1.12f, 0.0f}},
                                                    {kChest, {0.0f, 1.53f, 0.0f}},
                                                    {kChest, {0.18f, 1.42f, 0.0f}},
                                                    {kLeftArm, {0.23f, 1.12f, 0.0f}},
                                                    {kChest, {-0.18f, 1.42f, 0.0f}},
                                                    {kRightArm, {-0.23f, 1.12f, 0.0f}},
                                                    {kHips, {0.1f, 0.9f, 0.0f}},
                                                    {kLeftThigh, {0.1f, 0.48f, 0.0f}},
                                                    {kLeftShin, {0.1f, 0.08f, 0.0f}},
                                                    {kHips, {-0.1f, 0.9f, 0.0f}},
                                                    {kRightThigh, {-0.1f, 0.48f, 0.0f}},
                                                    {kRightShin, {-0.1f, 0.08f, 0.0f}}}};

/// How far a joint is bent at a moment of the stride, in turns about x; right limbs are half a
/// stride late. Forwards is negative for what hangs.
float bendAt(Joint joint, double stride) {
    const auto sine = [&](double phase) {
        return static_cast<float>(scene::builtin::sinCosTurns(stride + phase).sin);
    };
    switch (joint) {
        case kLeftThigh:
        case kRightThigh:
            return -0.075f * sine(0.0) - 0.01f;
        case kLeftShin:
        case kRightShin:
            return 0.055f + 0.06f * sine(0.3);
        case kLeftFoot:
        case kRightFoot:
            return -0.03f * sine(0.35) - 0.015f;
        case kLeftArm:
        case kRightArm:
            return 0.06f * sine(0.0);
        case kLeftForearm:
        case kRightForearm:
            return -0.06f + 0.03f * sine(0.0);
        default:
            return 0.0f;
    }
}

bool isRight(Joint joint) {
    return joint == kRightArm || joint == kRightForearm || joint >= kRightThigh;
}

glm::quat rotationAt(Joint joint, double stride) {
    const auto twist = static_cast<float>(scene::builtin::sinCosTurns(stride).sin);
    if (joint == kHips) return turned({0.0f, 1.0f, 0.0f}, -0.012 * twist);
    if (joint == kChest)
        return turned({0.0f, 1.0f, 0.0f}, 0.025 * twist) * turned({1.0f, 0.0f, 0.0f}, 0.008);
    if (joint == kHead) return turned({0.0f, 1.0f, 0.0f}, -0.013 * twist);
    return turned({1.0f, 0.0f, 0.0f}, bendAt(joint, isRight(joint) ? stride + 0.5 : stride));
}

/// A channel a joint, its node number the joint's, and the hips' bob.
assets::Animation makeStride() {
    constexpr int kKeys = 25;
    assets::Animation clip;
    clip.name = "stride";
    clip.durationSeconds = kStrideSeconds;
    assets::AnimationSampler times;
    for (int key = 0; key < kKeys; ++key)
        times.times.push_back(kStrideSeconds * static_cast<float>(key) / (kKeys - 1));
    for (uint32_t joint = 0; joint < kJointCount; ++joint) {
        assets::AnimationSampler sampler = times;
        sampler.components = 4;
        for (int key = 0; key < kKeys; ++key) {
            const glm::quat q = rotationAt(static_cast<Joint>(joint), key / (kKeys - 1.0));
            sampler.values.insert(sampler.values.end(), {q.x, q.y, q.z, q.w});
        }
        clip.channels.push_back({joint, joint, assets::AnimatedProperty::Rotation});
        clip.samplers.push_back(std::move(sampler));
    }
    assets::AnimationSampler bob = times;
    for (int key = 0; key < kKeys; ++key) {
        const auto step = scene::builtin::sinCosTurns(2.0 * key / (kKeys - 1.0));
        const glm::vec3 hips = kRest[kHips].positionMetres;
        bob.values.insert(bob.values.end(),
                          {hips.x, hips.y - 0.02f + 0.015f * static_cast<float>(step.cos), hips.z});
    }
    clip.channels.push_back({kJointCount, kHips, assets::AnimatedProperty::Translation});
    clip.samplers.push_back(std::move(bob));
    return clip;
}

}  // namespace

JointRest restOf(Joint joint) {
    return kRest[joint];
}

Figures makeFigures(scene::Library& library) {
    return {library.addMesh(makeFigureMesh()), library.addClip(makeStride())};
}

ecs::Entity spawnFigure(ecs::World& world, const Figures& figures, scene::MaterialId paint,
                        const scene::Transform& place, double startSeconds) {
    const ecs::Entity root = scene::spawn(world, "figure", place);
    world.add(root, scene::MeshInstance{figures.mesh, paint});
    scene::Skin skin;
    for (uint32_t i = 0; i < kJointCount; ++i) {
        const JointRest rest = kRest[i];
        const bool top = rest.parent == i;
        const glm::vec3 above = top ? glm::vec3(0.0f) : kRest[rest.parent].positionMetres;
        const ecs::Entity joint =
            scene::spawn(world, "figure's joint", {rest.positionMetres - above});
        CHECK(ecs::setParent(world, joint, top ? root : skin.joints[rest.parent]).ok());
        skin.joints.push_back(joint);
        skin.inverseBindMatrices.push_back(glm::translate(glm::mat4(1.0f), -rest.positionMetres));
    }
    world.add(root, scene::AnimationPlayer{.clip = figures.stride,
                                           .targets = skin.joints,
                                           .startSeconds = startSeconds,
                                           .loops = true});
    world.add(root, std::move(skin));
    return root;
}

void spawnWalkers(ecs::World& world, const Paints& paints) {
    constexpr float y = kSlabTopY;
    constexpr std::array<glm::vec3, 8> kRound{{{1.0f, y, 1.0f},
                                               {-1.4f, y, 2.0f},
                                               {-3.8f, y, 1.0f},
                                               {-4.6f, y, -0.8f},
                                               {-3.8f, y, -3.0f},
                                               {-1.4f, y, -3.9f},
                                               {1.0f, y, -3.0f},
                                               {1.8f, y, -0.8f}}};
    constexpr std::array<glm::vec3, 12> kThrough{{{-5.6f, y, -4.6f},
                                                  {-5.6f, 0.0f, -6.2f},
                                                  {-5.0f, 0.0f, -7.6f},
                                                  {-2.8f, 0.0f, -7.9f},
                                                  {0.0f, 0.0f, -7.8f},
                                                  {2.6f, 0.0f, -7.6f},
                                                  {2.8f, 0.0f, -6.2f},
                                                  {2.4f, y, -4.9f},
                                                  {1.0f, y, -4.7f},
                                                  {-0.6f, y, -4.9f},
                                                  {-2.4f, y, -4.9f},
                                                  {-4.2f, y, -4.6f}}};
    const auto& figures = world.resource<Figures>();
    const auto add = [&](std::span<const glm::vec3> way, scene::MaterialId paint, float start) {
        const ecs::Entity walker = spawnFigure(world, figures, paint, {}, -0.3 * start);
        world.add(walker, Travel{std::make_shared<Route>(way), kWalkMetresPerSecond, start});
    };
    add(kRound, paints.violet, 0.4f);
    add(kThrough, paints.linen, 2.0f);
}

}  // namespace lampyris::courtyard
