// How far each light reaches: to where its irradiance falls under `cutoff` of the frame's mean direct
// irradiance, both unshadowed and over a grid of pixels. Also the power so left out: what arrives at the
// seen surfaces from beyond a reach, in watts. One workgroup; sums in a fixed order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/direct.glsl"
#include "lib/surface.glsl"
#include "shared/direct.h"

layout(local_size_x = 256) in;  // REACH_THREADS
layout(push_constant) uniform Push { DirectParams params; };
layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer Lights { GpuLight lights[]; };
layout(set = 0, binding = SLOT_LIGHT_REACH, std430) writeonly buffer Reach { float reach[]; };

shared vec4 partial[REACH_THREADS];

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

float reachOf(GpuLight light, float mean) {
    return params.cutoff * mean <= 0.0
               ? 1e15
               : light.positionRadius.w + sqrt(luminance(light.power.rgb) / (4.0 * kPi * params.cutoff * mean));
}

// The sum over this thread's samples; with `mean` < 0 of the irradiance (a counts samples), else of what is cut off.
vec4 gatherSamples(uint thread, float mean) {
    vec4 sum = vec4(0.0);
    uint samples = params.cutoff > 0.0 ? params.reachGrid * params.reachGrid : 0u;
    for (uint s = thread; s < samples; s += REACH_THREADS) {
        vec2 at = (vec2(s % params.reachGrid, s / params.reachGrid) + 0.5) / float(params.reachGrid);
        ivec2 pixel = ivec2(at * vec2(view.width, view.height));
        float depth = depthAt(pixel);
        if (depth <= 0.0) continue;
        vec3 position = positionWorld(pixel, depth);
        vec3 normal = normalAt(pixel);
        // Surface seen by one sample's share of the image, m².
        float side = pixelFootprint(viewDepth(depth));
        float share = side * side * float(view.width * view.height) / float(params.reachGrid * params.reachGrid);
        float area = share / max(dot(normal, normalize(cameraWorld() - position)), 0.05);
        for (uint i = 0u; i < params.lightCount; ++i) {
            vec3 toLight = lights[i].positionRadius.xyz - position;
            if (mean >= 0.0 && length(toLight) <= reachOf(lights[i], mean)) continue;
            vec3 e = diffuseIrradiance(lights[i], toLight, normal);
            sum.rgb += mean >= 0.0 ? e * area : e;
        }
        sum.a += 1.0;
    }
    return sum;
}

vec4 sumOfPartials() {
    vec4 sum = vec4(0.0);
    for (uint i = 0u; i < REACH_THREADS; ++i) sum += partial[i];
    return sum;
}

// Every barrier stands outside all branches: lavapipe loses lanes at barriers under a condition.
void main() {
    uint thread = gl_LocalInvocationIndex;
    partial[thread] = gatherSamples(thread, -1.0);
    barrier();
    vec4 irradiance = sumOfPartials();
    float mean = luminance(irradiance.rgb) / max(irradiance.a, 1.0);
    barrier();
    partial[thread] = gatherSamples(thread, mean);
    barrier();
    vec4 cutOff = sumOfPartials();
    for (uint i = thread; i < params.lightCount; i += REACH_THREADS) reach[i] = reachOf(lights[i], mean);
    if (thread < 3u) reach[params.lightCount + thread] = cutOff[thread];
}
