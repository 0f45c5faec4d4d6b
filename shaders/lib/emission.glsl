// Where a path begins: a sphere light, a spot's cone, or a glowing triangle.
#ifndef LAMPYRIS_LIB_EMISSION
#define LAMPYRIS_LIB_EMISSION
#include "lib/emitter_table.glsl"
#include "lib/rng.glsl"
#include "lib/sampling.glsl"
#include "lib/sphere_light.glsl"
#include "shared/photon.h"
#include "shared/scene.h"

layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer EmissionLights { GpuLight emissionLights[]; };

struct PhotonRay {
    vec3 origin;
    vec3 direction;
    vec3 power;  // watts
};

// A path's way out of its part, and off the first surface: the range's own sequence goes on from frame to frame, without
// gaps while its paths are as many, so that both a frame's paths and the frames share them out evenly.    [P2]
vec4 pathPoint(PathRange range, uint local, uint seed, uint turn) {
    uvec2 corner = floatBitsToUint(range.part.xy);
    uvec2 own = tea(seedRandom(range.index | (range.kind << 30), seed) + corner, 8);
    vec4 xi = sobol4(turn * range.pathCount + local, uvec4(own, tea(own, 8)));
    return vec4(range.part.xy + range.part.zw * xi.xy, xi.zw);
}

// Points spread over the sphere, directions by cosine [Thesis 5.3.2.1].
PhotonRay emitFromSphere(PathRange range, GpuLight light, vec2 xi, inout uvec2 random) {
    vec3 outward = sampleSphere(xi);
    return PhotonRay(light.positionRadius.xyz + light.positionRadius.w * outward,
                     sampleCosine(outward, random2(random)), range.powerPerPath.rgb);
}

// A sphere sends the same power every way: draw the way first, in the cone if it has one, then the point on the half
// facing it. powerPerPath is that of the full cone; the falloff between the two angles weighs it.
PhotonRay emitByDirection(PathRange range, GpuLight light, vec2 xi, inout uvec2 random) {
    bool spot = light.power.w > -1.0;
    vec3 direction = sampleCone(spot ? light.direction.xyz : vec3(0.0, 1.0, 0.0), light.power.w, xi);
    vec2 disk = sampleDisk(random2(random));
    vec3 t, b;
    tangents(direction, t, b);
    vec3 outward = disk.x * t + disk.y * b + sqrt(max(0.0, 1.0 - dot(disk, disk))) * direction;
    float falloff = coneFactor(dot(direction, light.direction.xyz), light.direction.w, light.power.w);
    return PhotonRay(light.positionRadius.xyz + light.positionRadius.w * outward, direction,
                     range.powerPerPath.rgb * falloff);
}

// A triangle in proportion to its power, a point of it, a direction by cosine. A double-sided one glows both ways.
PhotonRay emitFromSurface(PathRange range, GpuEmitter emitter, vec2 xi, inout uvec2 random) {
    uint triangle = triangleByShare(emitter.firstTriangle, emitter.triangleCount, 1u, xi.x);
    vec3 origin = pointOfTriangle(triangle, random2(random));
    vec3 normal = normalize(cross(emitterTexel(triangle, 1u).xyz, emitterTexel(triangle, 2u).xyz));
    vec2 side = random2(random);
    if ((emitter.flags & INSTANCE_DOUBLE_SIDED) != 0u && side.x < 0.5) normal = -normal;
    // Triangles are chosen by the mean of rgb; the colour is the triangle's own.
    vec3 radiance = emitterTexel(triangle, 3u).rgb;
    float mean = dot(radiance, vec3(1.0 / 3.0));
    vec3 power = radiance * (range.powerPerPath.w / max(mean, 1e-30));
    return PhotonRay(origin + normal * (1e-5 * length(origin) + 1e-6), sampleCosine(normal, random2(random)), power);
}

PhotonRay emitPhoton(PathRange range, vec2 xi, inout uvec2 random) {
    if (range.kind == EMIT_SURFACE) return emitFromSurface(range, emitters[range.index], xi, random);
    GpuLight light = emissionLights[range.index];
    if (light.power.w > -1.0 || range.kind == EMIT_DIRECTION) return emitByDirection(range, light, xi, random);
    return emitFromSphere(range, light, xi, random);
}

#endif
