// Pixels that traced rays of their own share what they saw with others of their surface that did: a few rays a pixel
// are noise, and no history smooths them.                                                                          [F7]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/edge_list.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { GatherParams params; };
layout(set = 0, binding = SLOT_FINAL_JOINED) uniform sampler2D joined;
layout(set = 0, binding = SLOT_GATHER_ESTIMATES, std430) writeonly buffer Estimates { uvec2 estimates[]; };

// [chosen] Pixels to each side: 49 share, and a contact shadow is no softer than from the texels around.
const int kReach = 3;
// [chosen] Light is shared with normals that lean by less than 37 degrees: these pixels know no slope [F6].
const float kLeastCosine = 0.8;

void put(uint place, vec3 irradiance) {
    estimates[place] = uvec2(packHalf2x16(irradiance.rg), packHalf2x16(vec2(irradiance.b, 0.0)));
}

void main() {
    uint place = listPlace();
    if (place >= counters.pixelsRecomputed) return;
    ivec2 pixel = listedPixel(place);
    vec4 own = texelFetch(joined, pixel, 0);
    if (own.a > 0.0) {
        put(place, own.rgb);
        return;
    }
    float depth = depthAt(pixel);
    vec3 position = positionWorld(pixel, depth);
    vec3 normal = normalAt(pixel), plane = geometricNormalAt(pixel, depth);
    float spacing = pixelFootprint(viewDepth(depth)) * float(params.divisor);
    ivec2 last = ivec2(view.width, view.height) - 1;
    vec4 sum = (1.0 - kLeastCosine) * vec4(own.rgb, 1.0);
    for (int y = max(-kReach, -pixel.y); y <= min(kReach, last.y - pixel.y); ++y)
        for (int x = max(-kReach, -pixel.x); x <= min(kReach, last.x - pixel.x); ++x) {
            ivec2 at = pixel + ivec2(x, y);
            vec4 other = texelFetch(joined, at, 0);
            if (at == pixel || other.a > 0.0) continue;
            float off = abs(dot(plane, positionWorld(at, depthAt(at)) - position)) / (0.5 * spacing);
            float weight = max(dot(normal, normalAt(at)) - kLeastCosine, 0.0) * max(1.0 - off, 0.0);
            sum += weight * vec4(other.rgb, 1.0);
        }
    put(place, sum.rgb / sum.a);
}
