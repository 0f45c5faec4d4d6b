// One sphere light's unshadowed direct light on a surface.
#ifndef LAMPYRIS_LIB_DIRECT
#define LAMPYRIS_LIB_DIRECT
#include "lib/sphere_light.glsl"
#include "shared/scene.h"

// Irradiance at right angles to the way to the centre, Φ/(4πd²), cone included: W/m².
vec3 normalIrradiance(GpuLight light, vec3 toLight) {
    float d2 = max(dot(toLight, toLight), 1e-12);
    float cone = coneFactor(dot(-toLight * inversesqrt(d2), light.direction.xyz), light.direction.w,
                            light.power.w);
    return light.power.rgb * (cone / (4.0 * kPi * d2));
}

// Diffuse irradiance, the horizon's cut included: Φ·cos/(4πd²) where the whole sphere is above it.
vec3 diffuseIrradiance(GpuLight light, vec3 toLight, vec3 normal) {
    float d2 = max(dot(toLight, toLight), 1e-12);
    float radius = light.positionRadius.w;
    float sinSigma2 = radius * radius / d2;
    float cosTheta = dot(normal, toLight) * inversesqrt(d2);
    return normalIrradiance(light, toLight) * (sphereFormFactor(cosTheta, sinSigma2) / sinSigma2);
}

#endif
