// One thread a path: emission, then hit after hit. Stores the hits that TraceParams asks for, counts them,
// and books all power where it goes. Powers are divided by the paths emitted, here and nowhere else
// (PathRange.powerPerPath). Light from spheres is direct at its first hit: firstStored
// is 1 where direct light comes from elsewhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bvh_walk.glsl"
#include "lib/emission.glsl"
#include "lib/photon.glsl"
#include "lib/rng.glsl"
#include "lib/scene_material.glsl"

layout(local_size_x = 64) in;  // TRACE_THREADS
layout(push_constant) uniform Push { TraceParams params; };
layout(set = 0, binding = SLOT_PATH_RANGES, std430) readonly buffer Ranges { PathRange ranges[]; };
layout(set = 0, binding = SLOT_STAGED_PHOTONS, std430) writeonly buffer Staged { PackedPhoton staged[]; };
layout(set = 0, binding = SLOT_PATH_COUNTS, std430) writeonly buffer Counts { uint pathCounts[]; };
layout(set = 0, binding = SLOT_LEDGER, std430) writeonly buffer Ledger { float ledger[]; };

shared vec3 booked[TRACE_THREADS * 5u];

struct Booking {
    vec3 emitted, absorbed, escaped, inFlight, roulette;
};

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

PathRange rangeOf(uint path) {
    uint low = 0u, high = params.rangeCount - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) / 2u;
        if (ranges[middle].firstPath <= path) low = middle;
        else high = middle - 1u;
    }
    return ranges[low];
}

uint tracePath(uint slot, uint path, inout Booking book) {
    PathRange range = rangeOf(path);
    uvec2 random = seedRandom(path, params.seed);
    PhotonRay ray = emitPhoton(range, path - range.firstPath, params.seed, random);
    vec3 power = ray.power;
    book.emitted = power;
    uint stored = 0u;
    for (uint hitCount = 0u; power != vec3(0.0); ++hitCount) {
        Hit hit;
        if (!traceClosest(ray.origin, ray.direction, 0.0, 1e30, hit)) {
            book.escaped += power;
            break;
        }
        vec3 position = ray.origin + hit.t * ray.direction;
        if ((hitCount >= params.firstStored || range.kind == EMIT_SURFACE) && hitCount < params.endStored) {
            Photon photon = Photon(position, power / params.powerScale, ray.direction, hitCount, hit.instance, hit.normalWorld);
            staged[slot * params.photonsPerPath + stored] = packPhoton(photon);
            ++stored;
        }
        vec3 albedo = hitAlbedo(hit);
        vec3 reflected = power * albedo;
        book.absorbed += power - reflected;
        if (hitCount >= params.maxBounces) {
            book.inFlight += reflected;
            break;
        }
        if (hitCount >= params.rouletteFrom) {
            float survival = min(1.0, luminance(reflected) / max(luminance(power), 1e-30));
            if (random2(random).x >= survival) {
                book.roulette += reflected;
                break;
            }
            book.roulette -= reflected / survival - reflected;
            reflected /= survival;
        }
        vec3 normal = dot(hit.normalWorld, ray.direction) > 0.0 ? -hit.normalWorld : hit.normalWorld;
        ray.direction = sampleCosine(normal, random2(random));
        // Clear of the surface by more than the hit point's rounding.
        ray.origin = position + normal * (1e-5 * (length(position) + hit.t) + 1e-6);
        power = reflected;
    }
    return stored;
}

void main() {
    uint slot = gl_GlobalInvocationID.x;
    uint thread = gl_LocalInvocationIndex;
    Booking book = Booking(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    if (slot < params.pathCount) pathCounts[slot] = tracePath(slot, params.firstPath + slot, book);
    booked[thread] = book.emitted;
    booked[TRACE_THREADS + thread] = book.absorbed;
    booked[2u * TRACE_THREADS + thread] = book.escaped;
    booked[3u * TRACE_THREADS + thread] = book.inFlight;
    booked[4u * TRACE_THREADS + thread] = book.roulette;
    barrier();
    // In a fixed order, so that the same call gives the same sums.
    if (thread < 15u) {
        float sum = 0.0;
        for (uint i = 0u; i < TRACE_THREADS; ++i) sum += booked[(thread / 3u) * TRACE_THREADS + i][thread % 3u];
        ledger[gl_WorkGroupID.x * LEDGER_FLOATS + thread] = sum;
    }
}
