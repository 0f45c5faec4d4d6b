// Unit vectors as two 16-bit numbers (octahedral, Cigolle et al. 2014) and radiance with a shared exponent.
#ifndef LAMPYRIS_LIB_PACK
#define LAMPYRIS_LIB_PACK

vec2 signNotZero(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

uint packDirection(vec3 v) {
    vec2 p = v.xy / (abs(v.x) + abs(v.y) + abs(v.z));
    return packSnorm2x16(v.z <= 0.0 ? (1.0 - abs(p.yx)) * signNotZero(p) : p);
}

// The direction before it is made a unit vector: from 0.57 to 1 long.
vec3 unpackOctahedral(uint bits) {
    vec2 e = unpackSnorm2x16(bits);
    float z = 1.0 - abs(e.x) - abs(e.y);
    float fold = max(-z, 0.0);  // folds the lower half back; the same as Cigolle's decode
    return vec3(e.x + (e.x >= 0.0 ? -fold : fold), e.y + (e.y >= 0.0 ? -fold : fold), z);
}

vec3 unpackDirection(uint bits) { return normalize(unpackOctahedral(bits)); }

// Nine bits a channel and five of exponent (EXT_texture_shared_exponent's layout).
uint packSharedExponent(vec3 rgb) {
    vec3 c = clamp(rgb, vec3(0.0), vec3(65408.0));
    float top = max(max(c.r, c.g), max(c.b, 1.0 / 65536.0));
    int exponent = max(-15, int(floor(log2(top)))) + 1;
    float scale = exp2(float(9 - exponent));
    if (floor(top * scale + 0.5) >= 512.0) {
        exponent += 1;
        scale *= 0.5;
    }
    uvec3 m = uvec3(floor(c * scale + 0.5));
    return m.r | (m.g << 9) | (m.b << 18) | (uint(exponent + 15) << 27);
}

vec3 unpackSharedExponent(uint bits) {
    float scale = exp2(float(int(bits >> 27) - 15 - 9));
    return vec3(bits & 511u, (bits >> 9) & 511u, (bits >> 18) & 511u) * scale;
}

#endif
