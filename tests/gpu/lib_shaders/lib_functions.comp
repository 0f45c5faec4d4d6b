// What shaders/lib computes, laid out for a comparison with plain C++.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/pack.glsl"
#include "lib/rng.glsl"
#include "lib/sampling.glsl"
#include "lib/sphere_light.glsl"

layout(local_size_x = 64) in;
struct Row {
    vec4 radicalTea;      // radical inverse, tea x and y as bits, unused
    vec4 direction;       // on the sphere; w: form factor
    vec4 unpacked;        // the direction through 16-bit octahedral numbers; w: cosine sample's cosine
    vec4 exponent;        // a colour through the shared exponent
    vec4 sobol;           // a point of the scrambled sequence; as bits the index's places on a Z-order curve and in the net
    vec4 sobol4;          // a point of the one in four dimensions
};
layout(set = 0, binding = 0, std430) writeonly buffer Rows { Row rows[]; };
layout(push_constant) uniform Push { uint count; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    uvec2 hashed = tea(uvec2(i, 77u), 16);
    vec2 xi = hammersley(i, count);
    vec3 direction = sampleSphere(xi);
    float cosTheta = float(i % 101u) / 50.0 - 1.0;
    float sinSigma2 = (float(i / 101u % 50u) + 0.5) / 50.0;
    uvec2 state = seedRandom(i, 5u);
    vec3 scattered = sampleCosine(direction, random2(state));
    vec3 colour = vec3(random2(state), random2(state).x) * exp2(float(i % 20u) - 8.0);
    rows[i].radicalTea = vec4(radicalInverse2(i), uintBitsToFloat(hashed & 0x3fffffffu), 0.0);
    rows[i].direction = vec4(direction, sphereFormFactor(cosTheta, sinSigma2));
    rows[i].unpacked = vec4(unpackDirection(packDirection(direction)), dot(scattered, direction));
    rows[i].sobol = vec4(sobol2(i, uvec2(3u, 9u)), uintBitsToFloat(zOrder(uvec2(i & 255u, i >> 8))),
                         uintBitsToFloat(placeInNet(uvec2(i & 7u, (i >> 3) & 7u), i >> 6)));
    rows[i].sobol4 = sobol4(i, uvec4(3u, 9u, 27u, 81u));
    rows[i].exponent = vec4(colour - unpackSharedExponent(packSharedExponent(colour)), max(colour.r, max(colour.g, colour.b)));
}
