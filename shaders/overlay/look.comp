// Any image as something to look at, with a histogram, its range and the value under the cursor.
// LOOK_UINT: the image holds whole numbers. LOOK_ARRAY: it has layers.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/overlay.h"

layout(local_size_x = LOOK_THREADS, local_size_y = LOOK_THREADS) in;
layout(push_constant) uniform Push { LookParams params; };
#if defined(LOOK_UINT) && defined(LOOK_ARRAY)
layout(set = 0, binding = SLOT_LOOK_SOURCE) uniform usampler2DArray source;
#elif defined(LOOK_UINT)
layout(set = 0, binding = SLOT_LOOK_SOURCE) uniform usampler2D source;
#elif defined(LOOK_ARRAY)
layout(set = 0, binding = SLOT_LOOK_SOURCE) uniform sampler2DArray source;
#else
layout(set = 0, binding = SLOT_LOOK_SOURCE) uniform sampler2D source;
#endif
layout(set = 0, binding = SLOT_LOOK_SHOWN, rgba8) uniform writeonly image2D shown;
layout(set = 0, binding = SLOT_LOOK_FINDINGS, std430) buffer Findings { LookFindings findings; };

shared uint localBins[LOOK_CHANNELS * LOOK_BINS];
shared uint localLeastInverted, localMost, localBroken;

#ifdef LOOK_ARRAY
#define AT(texel) ivec3(texel, int(params.layer))
#else
#define AT(texel) texel
#endif

vec4 valueAt(ivec2 texel) { return vec4(texelFetch(source, AT(texel), 0)); }

// Floats in an order that unsigned comparison keeps.
uint ordered(float value) {
    uint bits = floatBitsToUint(value);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float encodeSrgb(float x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }

vec3 numbered(float value) {
    uint h = uint(value) * 2654435761u;
    h ^= h >> 15;
    h *= 2246822519u;
    return vec3(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u) / 255.0;
}

vec3 colourOf(vec4 value) {
    if (params.channel == LOOK_NUMBERED) return numbered(value.r);
    vec3 raw = params.channel == LOOK_COLOUR ? value.rgb : vec3(value[params.channel]);
    vec3 x = clamp((raw - params.offset) * params.gain, 0.0, 1.0);
    return params.encode == 1u ? vec3(encodeSrgb(x.r), encodeSrgb(x.g), encodeSrgb(x.b)) : x;
}

bool isShown(uint channel) { return params.channel >= LOOK_COLOUR ? channel < 3u : channel == params.channel; }

void count(vec4 value) {
    bool broken = false;
    for (uint i = 0u; i < params.channels; ++i) {
        if (isnan(value[i]) || isinf(value[i])) {
            broken = true;
            continue;
        }
        float x = (value[i] - params.offset) * params.gain;
        uint bin = uint(clamp(x * float(LOOK_BINS), 0.0, float(LOOK_BINS - 1u)));
        atomicAdd(localBins[i * LOOK_BINS + bin], 1u);
        if (!isShown(i)) continue;
        atomicMax(localLeastInverted, ~ordered(value[i]));
        atomicMax(localMost, ordered(value[i]));
    }
    if (broken) atomicAdd(localBroken, 1u);
}

void main() {
    uint thread = gl_LocalInvocationIndex;
    for (uint i = thread; i < LOOK_CHANNELS * LOOK_BINS; i += LOOK_THREADS * LOOK_THREADS) localBins[i] = 0u;
    if (thread == 0u) {
        localLeastInverted = 0u;
        localMost = 0u;
        localBroken = 0u;
    }
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 extent = textureSize(source, 0).xy;
    ivec2 size = imageSize(shown);
    if (all(lessThan(pixel, size))) {
        ivec2 first = pixel * extent / size;
        ivec2 end = (pixel + 1) * extent / size;
        for (int y = first.y; y < end.y; ++y)
            for (int x = first.x; x < end.x; ++x) count(valueAt(ivec2(x, y)));
        imageStore(shown, pixel, vec4(colourOf(valueAt(first)), 1.0));
    }
    ivec2 cursor = ivec2(params.cursorX, params.cursorY);
    if (pixel == ivec2(0) && all(lessThan(uvec2(cursor), uvec2(extent)))) {
        findings.underCursor = valueAt(cursor);
#ifdef LOOK_UINT
        findings.bitsUnderCursor = texelFetch(source, AT(cursor), 0);
#endif
    }
    barrier();
    for (uint i = thread; i < LOOK_CHANNELS * LOOK_BINS; i += LOOK_THREADS * LOOK_THREADS)
        if (localBins[i] > 0u) atomicAdd(findings.bins[i], localBins[i]);
    if (thread == 0u) {
        atomicMax(findings.leastInverted, localLeastInverted);
        atomicMax(findings.most, localMost);
        atomicAdd(findings.notFinite, localBroken);
    }
}
