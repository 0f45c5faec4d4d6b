// One level of an edge-stopping à-trous filter over low-resolution irradiance [Dammertz et al. 2010]. The levels past
// the first go by the noise that is left in the mean over frames, in how much they count and in which differences of
// light they take for it [Schied et al. 2017]: where noise falls, blur would remain.                            [F3]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_light.glsl"
#include "lib/gather_grid.glsl"
#include "lib/joint_weight.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_FINAL_COARSE_IN) uniform usampler2D coarse;
layout(set = 0, binding = SLOT_FINAL_GUIDE_IN) uniform usampler2D guide;
layout(set = 0, binding = SLOT_FINAL_COARSE, rgba32ui) uniform writeonly uimage2D filtered;

// [chosen] Under this noise a texel needs the others of the later levels no more.
const float kCalm = 0.01;
// [chosen] Of the noise: texels that differ by more differ in light.
const float kDeviations = 4.0;

float mean(CoarseLight light) { return dot(light.irradiance, vec3(1.0 / 3.0)); }

const float kSpline[3] = float[3](6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0);

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = ivec2(params.coarseWidth, params.coarseHeight);
    if (any(greaterThanEqual(texel, size))) return;
    uvec4 ownGuide = texelFetch(guide, texel, 0);
    if (ownGuide == kNoPlace) {
        imageStore(filtered, texel, packLight(CoarseLight(vec3(0.0), vec3(0.0), 1.0)));
        return;
    }
    Place own = placeOf(ownGuide);
    float z = -(view.worldToView * vec4(own.position, 1.0)).z;
    float spacing = pixelFootprint(z) * float(params.divisor * params.step);
    CoarseLight ownLight = unpackLight(texelFetch(coarse, texel, 0));
    CoarseLight sum = CoarseLight(vec3(0.0), vec3(0.0), ownLight.noise);
    bool first = params.step == 1u;
    bool unknown = ownLight.noise >= 1.0;
    float others = first ? 1.0 : min(ownLight.noise / kCalm, 1.0);
    float total = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            ivec2 at = texel + ivec2(x, y) * int(params.step);
            bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size));
            at = clamp(at, ivec2(0), size - 1);
            float weight = kSpline[abs(x)] * kSpline[abs(y)] *
                           jointWeight(own.position, own.normal, placeOf(texelFetch(guide, at, 0)), spacing);
            if (!inside) weight = 0.0;
            CoarseLight other = unpackLight(texelFetch(coarse, at, 0));
            // Either's noise: what is taken from a texel is given to it, and no light is lost.
            float spread = kDeviations * max(ownLight.noise * mean(ownLight), other.noise * mean(other));
            float apart = first || unknown ? 0.0 : abs(mean(other) - mean(ownLight)) / max(spread, 1e-30);
            if (x != 0 || y != 0) weight *= others * exp(-apart);
            addLeaning(sum, other, own.normal, weight);
            total += weight;
        }
    imageStore(filtered, texel, packLight(settled(sum, own.normal, 1.0 / max(total, 1e-30))));
}
