// Colours of what is drawn over the picture.
#ifndef LAMPYRIS_OVERLAY_MARK
#define LAMPYRIS_OVERLAY_MARK
#include "lib/photon.glsl"
#include "shared/overlay.h"
#include "shared/view.h"

layout(set = 0, binding = SLOT_VIEW) uniform ViewBlock { View view; };
layout(set = 0, binding = SLOT_MARK_PHOTONS, std430) readonly buffer Photons { PackedPhoton photons[]; };
layout(set = 0, binding = SLOT_MARK_OFFSETS, std430) readonly buffer Offsets { uint pathOffsets[]; };
layout(push_constant) uniform Push { MarkParams params; };

const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);  // outside of clip space

uint photonCount() { return min(pathOffsets[params.pathCount], params.capacity); }

// Every so many photons, or paths, one is drawn: they lie emitter by emitter, and all shall be seen. As markStride().
uint stride() { return max(1u, (max(photonCount(), params.pathCount) + params.most - 1u) / params.most); }

uint bounceOf(PackedPhoton p) { return p.powerDirection.x >> 16; }

vec3 bounceColour(uint bounce) {
    const vec3 colours[6] = vec3[](vec3(1.0, 1.0, 1.0), vec3(1.0, 0.8, 0.2), vec3(1.0, 0.4, 0.2),
                                   vec3(0.9, 0.2, 0.6), vec3(0.4, 0.4, 1.0), vec3(0.2, 0.8, 0.9));
    return colours[min(bounce, 5u)];
}

vec3 markColour(PackedPhoton p) {
    if (params.colouring == MARK_BY_BOUNCE) return bounceColour(bounceOf(p));
    vec3 watts = params.brightness * photonPower(p.positionPower, p.powerDirection);
    return pow(clamp(watts, 0.0, 1.0), vec3(1.0 / 2.2));
}

// A little towards the camera, so that what lies on a surface is not hidden by it.
vec4 marked(vec3 positionWorld) {
    vec4 clip = view.worldToClip * vec4(positionWorld, 1.0);
    clip.z *= 1.004;
    return clip;
}

#endif
