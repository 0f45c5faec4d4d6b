#include "scene/systems/animate.h"

#include <cmath>

#include "assets/animation_sampling.h"
#include "scene/library.h"
#include "scene/motion.h"

namespace lampyris::scene {

namespace {

using assets::AnimatedProperty;

/// The clip's time; finite.
double clipSeconds(const AnimationPlayer& player, const assets::Animation& clip, double seconds) {
    const double played = (seconds - player.startSeconds) * player.speed;
    if (!std::isfinite(played)) return 0.0;
    const auto duration = static_cast<double>(clip.durationSeconds);
    if (!player.loops || !(duration > 0.0)) return played;
    const double rest = std::fmod(played, duration);
    return rest < 0.0 ? rest + duration : rest;
}

/// Writes where the value is another, so that nothing is marked changed that stands still.
template <typename T>
void setPart(ecs::World& world, ecs::Entity target, T Transform::*part, const T& value) {
    const auto* present = world.find<Transform>(target);
    if (present != nullptr && present->*part != value)
        world.edit<Transform>(target, [&](Transform& transform) { transform.*part = value; });
}

void setWeights(ecs::World& world, ecs::Entity target, const assets::AnimationSampler& sampler,
                double seconds) {
    const auto* present = world.find<MorphWeights>(target);
    if (present == nullptr) return;
    std::vector<float> values(sampler.components);
    assets::sampleNumbers(sampler, seconds, values);
    if (present->values != values) world.set(target, MorphWeights{std::move(values)});
}

void playChannel(ecs::World& world, ecs::Entity target, AnimatedProperty property,
                 const assets::AnimationSampler& sampler, double seconds) {
    switch (property) {
        case AnimatedProperty::Translation:
            return setPart(world, target, &Transform::translation,
                           assets::sampleVector(sampler, seconds));
        case AnimatedProperty::Rotation:
            return setPart(world, target, &Transform::rotation,
                           assets::sampleRotation(sampler, seconds));
        case AnimatedProperty::Scale:
            return setPart(world, target, &Transform::scale,
                           assets::sampleVector(sampler, seconds));
        case AnimatedProperty::Weights:
            return setWeights(world, target, sampler, seconds);
    }
}

}  // namespace

void animate(ecs::World& world) {
    const auto* time = world.findResource<FrameTime>();
    const auto* library = world.findResource<Library>();
    if (time == nullptr || library == nullptr) return;
    for (const auto& [entity, player] : world.view<AnimationPlayer>()) {
        if (!player.clip.valid() || player.clip.value >= library->clips().size()) continue;
        const assets::Animation& clip = *library->clips()[player.clip.value];
        const double seconds = clipSeconds(player, clip, time->seconds);
        for (const assets::AnimationChannel& channel : clip.channels)
            if (channel.node < player.targets.size())
                playChannel(world, player.targets[channel.node], channel.property,
                            clip.samplers[channel.sampler], seconds);
    }
}

}  // namespace lampyris::scene
