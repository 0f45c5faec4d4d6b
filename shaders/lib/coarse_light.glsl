// Light on a low-resolution texel: irradiance, and how it changes where the surface leans.                        [F6]
#ifndef LAMPYRIS_LIB_COARSE_LIGHT
#define LAMPYRIS_LIB_COARSE_LIGHT

struct CoarseLight {
    vec3 irradiance;  // W/m², of the texel's own normal n
    vec3 slope;       // W/m², at right angles to n: the irradiance's mean changes by slope · m towards a normal m
    float noise;      // deviation of the irradiance around, a share of it; a guess in a mean's first frames
};

// Seven halves.
uvec4 packLight(CoarseLight light) {
    vec3 e = min(light.irradiance, vec3(65504.0));
    vec3 s = clamp(light.slope, vec3(-65504.0), vec3(65504.0));
    return uvec4(packHalf2x16(e.rg), packHalf2x16(vec2(e.b, light.noise)), packHalf2x16(s.xy),
                 packHalf2x16(vec2(s.z, 0.0)));
}

CoarseLight unpackLight(uvec4 bits) {
    vec2 rg = unpackHalf2x16(bits.x), bf = unpackHalf2x16(bits.y), xy = unpackHalf2x16(bits.z);
    return CoarseLight(vec3(rg, bf.x), vec3(xy, unpackHalf2x16(bits.w).x), bf.y);
}

// The slope over the irradiance's mean.
vec3 relativeSlope(CoarseLight light) { return light.slope / max(dot(light.irradiance, vec3(1.0 / 3.0)), 1e-30); }

// [chosen] Light all from one side goes to nothing where the surface turns away; what it turns to was not seen.
vec3 irradianceTowards(vec3 irradiance, vec3 relativeSlope, vec3 normal) {
    return irradiance * clamp(1.0 + dot(relativeSlope, normal), 0.05, 3.0);
}

// Adds another texel's light as a normal beside it sees it.
void addLeaning(inout CoarseLight sum, CoarseLight light, vec3 normal, float weight) {
    sum.irradiance += weight * light.irradiance * (1.0 + dot(relativeSlope(light), normal));
    sum.slope += weight * light.slope;
}

// Such a sum, brought to scale: no light below 0, and the slope at right angles to the normal again.
CoarseLight settled(CoarseLight sum, vec3 normal, float scale) {
    return CoarseLight(scale * max(sum.irradiance, vec3(0.0)), scale * (sum.slope - normal * dot(normal, sum.slope)),
                       sum.noise);
}

// Adds what comes from a direction: its share of the irradiance of a normal.
void addLight(inout CoarseLight light, vec3 irradiance, vec3 direction, vec3 normal) {
    light.irradiance += irradiance;
    // A normal m sees the share by (m · ω) / (n · ω). [chosen] Grazing light no steeper than 2 in 5: less noise.
    float cosine = dot(direction, normal);
    light.slope += dot(irradiance, vec3(1.0 / 3.0)) * (direction - cosine * normal) / max(cosine, 0.4);
}

#endif
