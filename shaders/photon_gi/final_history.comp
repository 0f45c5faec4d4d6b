// The mean of the last frames' light at each texel's place, found where that place was seen in the frame before.  [F4]
// The mean is shorter where the scene says that light may have changed [H1], and gives way where the newest light is not
// what the frames before led to expect [H2].
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_light.glsl"
#include "lib/gather_grid.glsl"
#include "lib/joint_weight.glsl"
#include "lib/scene_change.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_FINAL_COARSE_IN) uniform usampler2D coarse;
layout(set = 0, binding = SLOT_FINAL_GUIDE_IN) uniform usampler2D guide;
// No uniform: lavapipe compiles a shader anew for each value of one that its branches hang on, and keeps them all.
layout(set = 0, binding = SLOT_HISTORY_PARAMS, std430) readonly buffer HistoryBlock { HistoryParams past; };
layout(set = 0, binding = SLOT_HISTORY_BEFORE) uniform sampler2D meanBefore;    // irradiance, frames in the mean
layout(set = 0, binding = SLOT_HISTORY_SLOPE_BEFORE) uniform sampler2D slopeBefore;
layout(set = 0, binding = SLOT_HISTORY_GUIDE_BEFORE) uniform usampler2D guideBefore;
layout(set = 0, binding = SLOT_FINAL_COARSE, rgba32ui) uniform writeonly uimage2D meanShown;
// Floats: the steps of a long mean are smaller than a half's roundings.
layout(set = 0, binding = SLOT_HISTORY_MEAN, rgba32f) uniform writeonly image2D meanKept;
layout(set = 0, binding = SLOT_HISTORY_SLOPE, rgba32f) uniform writeonly image2D slopeKept;
layout(set = 0, binding = SLOT_FINAL_GUIDE, rgba32ui) uniform writeonly uimage2D guideKept;
layout(set = 0, binding = SLOT_HISTORY_MOMENTS_BEFORE) uniform sampler2D momentsBefore;
layout(set = 0, binding = SLOT_HISTORY_MOMENTS, rgba32f) uniform writeonly image2D momentsKept;
#ifdef MOVING
layout(set = 0, binding = SLOT_HISTORY_MOTION) uniform sampler2D motion;
#endif

// [chosen] Of the weight that texels on the same plane would have.
const float kLeastWeight = 0.05;
// [chosen] Share of the light by which a mean may lag behind a change that goes on.
const float kMostLag = 0.15;
// [chosen] The last frames' light, this far from what was expected, is no chance: fewer take sparks for changes, more
// leave small changes to the mean.
const float kDeviations = 3.0;
// [eq] What few frames tell of the spread may be too little by 1 + this / frames: one case in a hundred of χ².
const float kFewFrames = 12.0;
const float kNewest = 0.25;  // a frame's weight in the last frames' light: its spread is √(1/7) of a frame's
const float kLeastDeviation = 0.02;
// [chosen] Frames before a spread is known.
const float kFramesToJudge = 6.0;
// [chosen] A mean with a smaller share of frames from before the last change is left alone: they can hide little.
const float kLeastStale = 0.125;

struct Remembered {
    CoarseLight light;
    float frames;  // in it
    vec4 moments;  // of the newest light around: mean, mean square, mean of the last frames; frames before a change
};

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
Remembered rememberedAt(Place place) {
    CoarseLight sum = CoarseLight(vec3(0.0), vec3(0.0), 1.0);
    float frames = 0.0;
    vec4 moments = vec4(0.0);
    vec4 clip = past.worldToClipBefore * vec4(place.position, 1.0);
    if (clip.w <= 0.0) return Remembered(sum, 0.0, moments);
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
        CoarseLight light = CoarseLight(irradianceFrames.rgb, texelFetch(slopeBefore, texel, 0).xyz, 1.0);
        addLeaning(sum, light, place.normal, weight);
        frames += weight * irradianceFrames.a;
        moments += weight * texelFetch(momentsBefore, texel, 0);
        total += weight;
    }
    float scale = total >= kLeastWeight ? 1.0 / total : 0.0;
    return Remembered(settled(sum, place.normal, scale), scale * frames, scale * moments);
}

float mean(vec3 rgb) { return dot(rgb, vec3(1.0 / 3.0)); }

// Mean of the newest light on the surface around a texel: less noise, the same change.
float newestAround(ivec2 texel, Place own) {
    ivec2 size = ivec2(params.coarseWidth, params.coarseHeight);
    float spacing = pixelFootprint(-(view.worldToView * vec4(own.position, 1.0)).z) * float(2u * params.divisor);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 9; ++i) {
        ivec2 at = clamp(texel + 2 * ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), size - 1);
        float weight = jointWeight(own.position, own.normal, placeOf(texelFetch(guide, at, 0)), spacing);
        if (i == 4) weight = 1.0;
        sum += weight * vec4(unpackLight(texelFetch(coarse, at, 0)).irradiance, 1.0);
    }
    return mean(sum.rgb) / sum.a;
}

// How much of what is remembered must give way to what the last frames saw.                                        [H2]
float disagreement(vec4 moments, float frames) {
    float deviation = sqrt(max(moments.y - moments.x * moments.x, 0.0) * (kNewest / (2.0 - kNewest) + 1.0 / frames));
    deviation *= 1.0 + kFewFrames / frames;
    float limit = kDeviations * deviation + kLeastDeviation * moments.x;
    return clamp(1.0 - limit / max(abs(moments.z - moments.x), 1e-30), 0.0, 1.0);
}

// How much a mean of so many frames still trembles, as a share of it.                                              [F3]
float noiseOf(vec4 moments, float frames) {
    if (frames < kFramesToJudge) return 1.0 / frames;
    float deviation = sqrt(max(moments.y - moments.x * moments.x, 0.0) / (2.0 * frames - 1.0));
    return min(deviation / max(moments.x, 1e-30), 1.0);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= int(params.coarseWidth) || texel.y >= int(params.coarseHeight)) return;
    uvec4 own = texelFetch(guide, texel, 0);
    imageStore(guideKept, texel, own);
    CoarseLight light = unpackLight(texelFetch(coarse, texel, 0));
    Place place = placeOf(own);
    float seen = newestAround(texel, place);
    vec4 moments = vec4(seen, seen * seen, seen, 0.0);
    float inMean = 1.0;
    if (past.mostFrames > 0u) {
        Place before = place;
#ifdef MOVING
        before.position += texelFetch(motion, representative(texel), 0).xyz;
#endif
        Remembered remembered = rememberedAt(before);
        float known = min(floor(remembered.frames + 0.5), float(past.mostFrames));  // that the moments are of
        float frames = known;
        float change = changeByRegions(place.position, past.regionCount);
        if (past.lightCount > 0u) change += changeByLights(place.position, past.regionCount, past.lightCount);
        if (change > 0.0) frames = min(frames, kMostLag / change);
        float stale = change > 0.0 ? frames : min(remembered.moments.w * known / max(remembered.frames, 1.0), frames);
        if (frames > 0.0) moments.z = mix(remembered.moments.z, seen, max(kNewest, 1.0 / (frames + 1.0)));
        if (past.doubted != 0u && frames >= kFramesToJudge && stale >= kLeastStale * frames) {
            remembered.moments.z = moments.z;
            float given = disagreement(remembered.moments, known);
            float scale = mix(1.0, moments.z / max(remembered.moments.x, 1e-30), given);
            remembered.light.irradiance *= scale;
            remembered.light.slope *= scale;
            remembered.moments.xy *= vec2(scale, scale * scale);
            frames *= (1.0 - given) * (1.0 - given);
            stale *= 1.0 - given;
        }
        inMean = frames + 1.0;
        light.irradiance = mix(remembered.light.irradiance, light.irradiance, 1.0 / inMean);
        light.slope = mix(remembered.light.slope, light.slope, 1.0 / inMean);
        moments.w = min(stale, frames);
        moments.xy = mix(remembered.moments.xy, moments.xy, 1.0 / inMean);
    }
    imageStore(meanKept, texel, vec4(light.irradiance, inMean));
    light.noise = noiseOf(moments, inMean);
    imageStore(meanShown, texel, packLight(light));
    imageStore(slopeKept, texel, vec4(light.slope, 0.0));
    imageStore(momentsKept, texel, moments);
}
