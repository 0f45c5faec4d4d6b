#include <cmath>

#include "assets/gltf_accessor.h"

namespace lampyris::assets {
namespace {

const tinygltf::Accessor& accessorOf(const GltfSource& source, int index) {
    return source.document.accessors[static_cast<size_t>(index)];
}

core::Result<void> checkKeys(const AnimationSampler& sampler, GltfContext& context,
                             const std::string& place) {
    for (size_t i = 0; i < sampler.times.size(); ++i) {
        const float time = sampler.times[i];
        if (!std::isfinite(time) || (i > 0 && time <= sampler.times[i - 1]))
            return context.error(place, "key {} is at {} s and not after the one before", i, time);
    }
    for (const float value : sampler.values)
        if (!std::isfinite(value)) return context.error(place, "a value is not finite");
    return {};
}

core::Result<AnimationSampler> readSampler(GltfSource& source,
                                           const tinygltf::AnimationSampler& from,
                                           const std::string& place) {
    AnimationSampler to;
    if (from.interpolation == "STEP")
        to.interpolation = Interpolation::Step;
    else if (from.interpolation == "CUBICSPLINE")
        to.interpolation = Interpolation::CubicSpline;
    else if (from.interpolation != "LINEAR")
        return source.context.error(place, "has the unknown interpolation {}", from.interpolation);
    TRY(to.times, readFloats(source, from.input, 1, allOf(source, from.input)));
    const size_t elementSize = componentCount(accessorOf(source, from.output));
    TRY(to.values, readFloats(source, from.output, elementSize, allOf(source, from.output)));
    const size_t slots = to.times.size() * (to.interpolation == Interpolation::CubicSpline ? 3 : 1);
    const size_t elements = to.values.size() / elementSize;
    const bool fits = elementSize == 1 ? elements % slots == 0 : elements == slots;
    if (!fits)
        return source.context.error(place, "has {} values for {} keys", elements, to.times.size());
    to.components = static_cast<uint32_t>(to.values.size() / slots);
    TRY_VOID(checkKeys(to, source.context, place));
    return to;
}

/// What a path drives and how many components that takes in this node; nothing for an unknown path.
std::optional<std::pair<AnimatedProperty, size_t>> propertyOf(const std::string& path,
                                                              const ModelNode& node,
                                                              const Model& model) {
    if (path == "translation") return std::pair{AnimatedProperty::Translation, size_t{3}};
    if (path == "rotation") return std::pair{AnimatedProperty::Rotation, size_t{4}};
    if (path == "scale") return std::pair{AnimatedProperty::Scale, size_t{3}};
    if (path != "weights" || node.primitives.empty()) return {};
    return std::pair{AnimatedProperty::Weights,
                     model.meshes[node.primitives.front().mesh].morphTargets.size()};
}

/// Whether a key turns nowhere: such are taken as no rotation.
bool anyWithoutDirection(const AnimationSampler& sampler) {
    const size_t key = sampler.interpolation == Interpolation::CubicSpline ? 12 : 4;
    for (size_t i = key == 12 ? 4 : 0; i + 3 < sampler.values.size(); i += key) {
        const float* q = &sampler.values[i];
        if (q[0] == 0.0f && q[1] == 0.0f && q[2] == 0.0f && q[3] == 0.0f) return true;
    }
    return false;
}

void readChannel(const tinygltf::AnimationChannel& from, const Model& model, GltfContext& context,
                 const std::string& place, Animation& animation) {
    if (from.target_node < 0) return;  // glTF 2.0, 3.11: such a channel is for extensions
    const auto node = static_cast<uint32_t>(from.target_node);
    const auto sampler = static_cast<uint32_t>(from.sampler);
    const auto property = propertyOf(from.target_path, model.nodes[node], model);
    if (!property || property->second != animation.samplers[sampler].components) {
        context.warn(place, "does not fit {} of node {}, and is left out", from.target_path, node);
        return;
    }
    if (property->first == AnimatedProperty::Rotation &&
        anyWithoutDirection(animation.samplers[sampler]))
        context.warn(place, "has rotations of length 0; none stands in");
    animation.channels.push_back({sampler, node, property->first});
}

core::Result<Animation> readAnimation(GltfSource& source, const tinygltf::Animation& from,
                                      const std::string& place, const Model& model) {
    Animation animation;
    animation.name = from.name;
    for (const tinygltf::AnimationSampler& sampler : from.samplers) {
        TRY(AnimationSampler read,
            readSampler(source, sampler,
                        fmt::format("{}/samplers/{}", place, animation.samplers.size())));
        animation.samplers.push_back(std::move(read));
    }
    for (size_t i = 0; i < from.channels.size(); ++i)
        readChannel(from.channels[i], model, source.context,
                    fmt::format("{}/channels/{}", place, i), animation);
    for (const AnimationChannel& channel : animation.channels)
        animation.durationSeconds =
            std::max(animation.durationSeconds, animation.samplers[channel.sampler].times.back());
    return animation;
}

}  // namespace

void readAnimations(GltfSource& source, Model& model) {
    const std::vector<tinygltf::Animation>& animations = source.document.animations;
    for (size_t i = 0; i < animations.size(); ++i) {
        auto animation =
            readAnimation(source, animations[i], fmt::format("/animations/{}", i), model);
        if (animation && !animation->channels.empty())
            model.animations.push_back(std::move(animation).value());
        else if (animation)
            source.context.warn(fmt::format("/animations/{}", i), "moves nothing; left out");
        else
            core::logWarning("{}; the animation is left out", animation.error().message);
    }
}

}  // namespace lampyris::assets
