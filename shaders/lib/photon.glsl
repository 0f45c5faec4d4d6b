// A photon in memory: two texels of four 32-bit words.
#ifndef LAMPYRIS_LIB_PHOTON
#define LAMPYRIS_LIB_PHOTON
#include "lib/pack.glsl"
#include "shared/photon.h"

struct Photon {
    vec3 positionWorld;
    vec3 power;       // of powerScale watts
    vec3 direction;   // of travel, towards the surface
    uint bounce;
    uint instance;
    vec3 normal;      // geometric, to the front side
};

PackedPhoton packPhoton(Photon p) {
    return PackedPhoton(
        uvec4(floatBitsToUint(p.positionWorld), packHalf2x16(p.power.rg)),
        uvec4((packHalf2x16(vec2(p.power.b, 0.0)) & 0xffffu) | (p.bounce << 16), packDirection(p.direction),
              p.instance, packDirection(p.normal)));
}

vec3 photonPosition(uvec4 positionPower) { return uintBitsToFloat(positionPower.xyz); }

vec3 photonPower(uvec4 positionPower, uvec4 powerDirection) {
    return vec3(unpackHalf2x16(positionPower.w), unpackHalf2x16(powerDirection.x).x);
}

vec3 photonDirection(uvec4 powerDirection) { return unpackDirection(powerDirection.y); }

vec3 photonNormal(uvec4 powerDirection) { return unpackDirection(powerDirection.w); }

#endif
