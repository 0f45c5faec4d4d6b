// One thread a path: emission, then hit after hit. Stores the hits that TraceParams asks for, counts them,
// and books all power where it goes. Powers are divided by the paths emitted, here and nowhere else
// (PathRange.powerPerPath). Light from spheres is direct at its first hit: firstStored
// is 1 where direct light comes from elsewhere. KEEP: traces the chosen paths alone, into a path store. [K1]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bvh_walk.glsl"
#include "lib/emission.glsl"
#include "lib/path_range.glsl"
#include "lib/photon.glsl"
#include "lib/rng.glsl"
#include "lib/scene_material.glsl"

layout(local_size_x = 64) in;  // TRACE_THREADS
layout(push_constant) uniform Push { TraceParams params; };
layout(set = 0, binding = SLOT_STAGED_PHOTONS, std430) writeonly buffer Staged { PackedPhoton staged[]; };
layout(set = 0, binding = SLOT_PATH_COUNTS, std430) writeonly buffer Counts { uint pathCounts[]; };
#ifdef KEEP
layout(set = 0, binding = SLOT_CHOSEN_PATHS, std430) readonly buffer Chosen { uint chosen[]; };
layout(set = 0, binding = SLOT_KEPT_VERTICES, std430) buffer Vertices { vec4 vertices[]; };
layout(set = 0, binding = SLOT_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_BOOKINGS, std430) writeonly buffer Bookings { float bookings[]; };
#else
layout(set = 0, binding = SLOT_LEDGER, std430) writeonly buffer Ledger { float ledger[]; };

shared vec3 booked[TRACE_THREADS * 5u];
#endif

struct Booking {
    vec3 emitted, absorbed, escaped, inFlight, roulette;
};

#ifdef KEEP
const uint kNormal = 0x40000000u;  // of a float: no device takes such bits for 0
const float kFarAway = 1e6;  // [chosen] metres: past any scene
#endif

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

uint tracePath(uint slot, uint path, uint turn, inout Booking book) {
    PathRange range = ranges[rangeIndexOf(path, params.rangeCount)];
    uvec2 random = seedRandom(path, turnSeed(params.seed, turn));
    vec4 point = pathPoint(range, path - range.firstPath, params.seed, turn);
    PhotonRay ray = emitPhoton(range, point.xy, random);
    vec3 power = ray.power;
    book.emitted = power;
    uint stored = 0u;
#ifdef KEEP
    uint firstVertex = slot * params.verticesPerPath, vertexCount = 1u;
    vec3 start = ray.origin;
#endif
    for (uint hitCount = 0u; power != vec3(0.0); ++hitCount) {
        Hit hit;
        if (!traceClosest(ray.origin, ray.direction, 0.0, 1e30, hit)) {
            book.escaped += power;
#ifdef KEEP
            vertices[firstVertex + vertexCount++] = vec4(ray.origin + kFarAway * ray.direction, 0.0);
#endif
            break;
        }
        vec3 position = ray.origin + hit.t * ray.direction;
#ifdef KEEP
        vertices[firstVertex + vertexCount++] = vec4(position, 0.0);
#endif
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
        vec2 xi = random2(random);
        ray.direction = sampleCosine(normal, hitCount == 0u ? point.zw : xi);
        // Clear of the surface by more than the hit point's rounding.
        ray.origin = position + normal * (1e-5 * (length(position) + hit.t) + 1e-6);
        power = reflected;
    }
#ifdef KEEP
    vertices[firstVertex] = vec4(start, uintBitsToFloat(vertexCount));
    vertices[firstVertex + 1u].w = uintBitsToFloat(turn | kNormal);
#endif
    return stored;
}

#ifdef KEEP
void main() {
    if (gl_GlobalInvocationID.x >= counters.pathsRetraced) return;
    uint path = chosen[gl_GlobalInvocationID.x] & ~CHOSEN_ANEW;
    bool anew = (chosen[gl_GlobalInvocationID.x] & CHOSEN_ANEW) != 0u;
    uint turn = anew ? params.turn : floatBitsToUint(vertices[path * params.verticesPerPath + 1u].w) & ~kNormal;
    Booking book = Booking(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    pathCounts[path] = tracePath(path, path, turn, book);
    vec3 accounts[5] = vec3[5](book.emitted, book.absorbed, book.escaped, book.inFlight, book.roulette);
    for (uint i = 0u; i < BOOKED; ++i) bookings[path * BOOKING_FLOATS + i] = accounts[i / 3u][i % 3u];
}
#else
void main() {
    uint slot = gl_GlobalInvocationID.x;
    uint thread = gl_LocalInvocationIndex;
    Booking book = Booking(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    if (slot < params.pathCount) pathCounts[slot] = tracePath(slot, params.firstPath + slot, params.turn, book);
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
#endif
