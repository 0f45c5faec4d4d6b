// Light from a sphere of uniform radiance on a surface: irradiance, and GGX by the representative point.
#ifndef LAMPYRIS_LIB_SPHERE_LIGHT
#define LAMPYRIS_LIB_SPHERE_LIGHT
#include "lib/sampling.glsl"

// Cosine-weighted solid angle over pi of a sphere whose centre lies at angle theta from the normal,
// cut at the horizon. sinSigma2 = r²/d². Above the horizon it is cosTheta·sinSigma2, exactly.
// Below, the closed form of a cut sphere (Snyder 1996).
float sphereFormFactor(float cosTheta, float sinSigma2) {
    if (sinSigma2 >= 1.0) return 1.0;
    if (cosTheta * cosTheta >= sinSigma2) return max(cosTheta, 0.0) * sinSigma2;
    float sinTheta = sqrt(max(0.0, 1.0 - cosTheta * cosTheta));
    float x = sqrt(1.0 / sinSigma2 - 1.0);
    float y = clamp(-x * (cosTheta / sinTheta), -1.0, 1.0);
    float z = sinTheta * sqrt(1.0 - y * y);
    return max(0.0, ((cosTheta * acos(y) - x * z) * sinSigma2 + atan(z / x)) / kPi);
}

// Falloff inside a cone as KHR_lights_punctual recommends; 1 for a full sphere.
float coneFactor(float cosAngle, float cosInner, float cosOuter) {
    if (cosOuter <= -1.0) return 1.0;
    float t = clamp((cosAngle - cosOuter) / max(cosInner - cosOuter, 1e-4), 0.0, 1.0);
    return t * t;
}

// Trowbridge-Reitz times Smith and Schlick [Thesis eq. 4.4 to 4.8], times n·l.
// alpha = roughness², alphaWide the same widened by the light's radius.
vec3 ggxTimesCosine(vec3 n, vec3 v, vec3 l, float roughness, vec3 f0) {
    vec3 h = normalize(v + l);
    float nl = max(dot(n, l), 0.0);
    float nv = max(dot(n, v), 1e-4);
    float nh = max(dot(n, h), 0.0);
    float vh = max(dot(v, h), 0.0);
    float alpha2 = pow(max(roughness, 0.03), 4.0);
    float d = nh * nh * (alpha2 - 1.0) + 1.0;
    float distribution = alpha2 / (kPi * d * d);
    float k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
    float smith = (nl / (nl * (1.0 - k) + k)) * (nv / (nv * (1.0 - k) + k));
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
    return fresnel * (distribution * smith / (4.0 * nv));
}

// Karis's representative point [Thesis listings 5.1, 5.2]: toLight is centre minus position.
// Returns BRDF · cosine, to be multiplied by the centre's normal irradiance Φ/(4πd²).
vec3 sphereSpecular(vec3 n, vec3 v, vec3 toLight, float radius, float roughness, vec3 f0) {
    vec3 r = reflect(-v, n);
    vec3 toRay = dot(toLight, r) * r - toLight;
    vec3 point = toLight + toRay * clamp(radius / max(length(toRay), 1e-6), 0.0, 1.0);
    float alpha = max(roughness * roughness, 0.0009);
    float wide = clamp(alpha + radius / (2.0 * length(toLight)), 0.0, 1.0);
    float normalisation = (alpha / wide) * (alpha / wide);
    return ggxTimesCosine(n, v, normalize(point), roughness, f0) * normalisation;
}

#endif
