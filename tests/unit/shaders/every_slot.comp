#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/glsl_compat.h"
LAMPYRIS_SLOT(SLOT_PLAIN, 1u);
layout(local_size_x = 16, local_size_y = 4) in;
#ifndef VARIANT
layout(binding = 0) readonly buffer Inputs { uint values[]; } inputs;
#endif
layout(binding = SLOT_PLAIN) buffer Plain { uint plainValues[]; };
layout(binding = 2) writeonly buffer Outputs { uint values[]; } outputs;
layout(binding = 3) buffer Mixed { readonly uint a; uint b; } mixed;
layout(binding = 4) uniform samplerBuffer texels;
layout(binding = 5, r32f) uniform writeonly imageBuffer storedTexels;
layout(binding = 6) uniform usampler2DArray layers;
layout(binding = 7, r32ui) uniform readonly uimage2D readImage;
layout(binding = 8, r32ui) uniform uimage2D updatedImage;
layout(binding = 9) uniform Params { vec4 value; } params;
layout(push_constant) uniform Push { vec4 a; uint b; } push;
void main() {}
