// The mean of the last frames' light at each texel's place, found where that place was seen in the frame before.  [F4]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_light.glsl"
#include "lib/gather_grid.glsl"
#include "lib/joint_weight.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_FINAL_COARSE_IN) uniform usampler2D coarse;
layout(set = 0, binding = SLOT_FINAL_GUIDE_IN) uniform usampler2D guide;
layout(set = 0, binding = SLOT_HISTORY_PARAMS, std140) uniform HistoryBlock { HistoryParams past; };
layout(set = 0, binding = SLOT_HISTORY_BEFORE) uniform sampler2D meanBefore;    // irradiance, frames in the mean
layout(set = 0, binding = SLOT_HISTORY_SLOPE_BEFORE) uniform sampler2D slopeBefore;
layout(set = 0, binding = SLOT_HISTORY_GUIDE_BEFORE) uniform usampler2D guideBefore;
layout(set = 0, binding = SLOT_FINAL_COARSE, rgba32ui) uniform writeonly uimage2D mean;
// Floats: the steps of a long mean are smaller than a half's roundings.
layout(set = 0, binding = SLOT_HISTORY_MEAN, rgba32f) uniform writeonly image2D meanKept;
layout(set = 0, binding = SLOT_HISTORY_SLOPE, rgba32f) uniform writeonly image2D slopeKept;
layout(set = 0, binding = SLOT_FINAL_GUIDE, rgba32ui) uniform writeonly uimage2D guideKept;

// [chosen] Of the weight that texels on the same plane would have.
const float kLeastWeight = 0.05;

// Where a pixel lies between texels; the last representatives stand nearer, at the image's edge.
vec2 texelCoordinate(vec2 pixel) {
    ivec2 last = ivec2(params.coarseWidth, params.coarseHeight) - 1;
    ivec2 nextToLast = max(last - 1, ivec2(0));
    vec2 before = vec2(representative(nextToLast)) + 0.5;
    vec2 span = max(vec2(representative(last)) + 0.5 - before, vec2(1.0));
    vec2 regular = (pixel - 0.5 - float(params.divisor / 2u)) / float(params.divisor);
    return mix(regular, vec2(nextToLast) + (pixel - before) / span, greaterThan(pixel, before));
}

// The mean at a place of the world, as the frame before left it; no frames where it did not see it.
CoarseLight rememberedAt(Place place) {
    CoarseLight sum = CoarseLight(vec3(0.0), vec3(0.0), 0.0);
    vec4 clip = past.worldToClipBefore * vec4(place.position, 1.0);
    if (clip.w <= 0.0) return sum;
    vec2 pixel = (clip.xy / clip.w * 0.5 + 0.5) * vec2(view.width, view.height);
    vec2 at = texelCoordinate(pixel);
    vec2 f = fract(at);
    float spacing = pixelFootprint(clip.w) * float(params.divisor);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 texel = ivec2(floor(at)) + corner;
        bool inside = all(greaterThanEqual(texel, ivec2(0))) &&
                      all(lessThan(texel, ivec2(params.coarseWidth, params.coarseHeight)));
        texel = clamp(texel, ivec2(0), ivec2(params.coarseWidth, params.coarseHeight) - 1);
        vec2 bilinear = mix(1.0 - f, f, vec2(corner));
        Place before = placeOf(texelFetch(guideBefore, texel, 0));
        float weight = bilinear.x * bilinear.y * jointWeight(place.position, place.normal, before, spacing);
        if (!inside) weight = 0.0;
        vec4 irradianceFrames = texelFetch(meanBefore, texel, 0);
        CoarseLight light =
            CoarseLight(irradianceFrames.rgb, texelFetch(slopeBefore, texel, 0).xyz, irradianceFrames.a);
        addLeaning(sum, light, place.normal, weight);
        sum.frames += weight * light.frames;
        total += weight;
    }
    float scale = total >= kLeastWeight ? 1.0 / total : 0.0;
    CoarseLight light = settled(sum, place.normal, scale);
    light.frames = scale * sum.frames;
    return light;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= int(params.coarseWidth) || texel.y >= int(params.coarseHeight)) return;
    uvec4 own = texelFetch(guide, texel, 0);
    imageStore(guideKept, texel, own);
    CoarseLight light = unpackLight(texelFetch(coarse, texel, 0));
    if (past.mostFrames > 0u) {
        CoarseLight remembered = rememberedAt(placeOf(own));
        light.frames = min(floor(remembered.frames + 0.5), float(past.mostFrames)) + 1.0;
        light.irradiance = mix(remembered.irradiance, light.irradiance, 1.0 / light.frames);
        light.slope = mix(remembered.slope, light.slope, 1.0 / light.frames);
    }
    imageStore(mean, texel, packLight(light));
    imageStore(meanKept, texel, vec4(light.irradiance, light.frames));
    imageStore(slopeKept, texel, vec4(light.slope, 0.0));
}
