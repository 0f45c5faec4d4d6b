/// \file Keyframes as glTF 2.0 has them; the values of all channels are kept as floats.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lampyris::assets {

enum class Interpolation : uint8_t { Linear, Step, CubicSpline };
enum class AnimatedProperty : uint8_t { Translation, Rotation, Scale, Weights };

/// Keys over time. A key holds `components` floats; with CubicSpline three times as many
/// (in-tangent, value, out-tangent).
struct AnimationSampler {
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> times;  ///< seconds, strictly increasing, at least one
    uint32_t components =
        3;  ///< 3 for translation and scale, 4 for rotation (x y z w), a float a target for weights
    std::vector<float> values;  ///< times · components (· 3)
};

/// What a sampler drives.
struct AnimationChannel {
    uint32_t sampler = 0;  ///< into Animation::samplers
    uint32_t node = 0;     ///< into Model::nodes
    AnimatedProperty property = AnimatedProperty::Translation;
};

struct Animation {
    std::string name;
    std::vector<AnimationSampler> samplers;
    std::vector<AnimationChannel> channels;
    float durationSeconds = 0.0f;  ///< the last key
};

}  // namespace lampyris::assets
