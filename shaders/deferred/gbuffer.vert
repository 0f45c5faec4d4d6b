#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/place.glsl"
#include "shared/gbuffer.h"
#include "shared/view.h"

layout(set = 0, binding = SLOT_VIEW) uniform ViewBlock { View view; };
layout(set = 0, binding = SLOT_INSTANCES, std430) readonly buffer Instances { GpuInstance instances[]; };
layout(push_constant) uniform Push { GBufferDraw drawn; };

layout(location = STREAM_POSITION) in vec3 position;
layout(location = STREAM_NORMAL) in vec3 normal;
layout(location = STREAM_TANGENT) in vec4 tangent;
layout(location = STREAM_TEXCOORDS) in vec4 texcoords;
layout(location = STREAM_COLOUR) in vec4 colour;

invariant gl_Position;  // motion.vert lies on the same depths
layout(location = 0) out vec3 positionWorldOut;
layout(location = 1) out vec3 normalWorldOut;
layout(location = 2) out vec4 tangentWorldOut;
layout(location = 3) out vec4 texcoordsOut;
layout(location = 4) out vec4 colourOut;

void main() {
    GpuInstance i = instances[drawn.instance];
    positionWorldOut = placed(position, i.objectToWorld0, i.objectToWorld1, i.objectToWorld2);
    // Normals go by the inverse transpose, tangents by the matrix itself.
    normalWorldOut = normal.x * i.worldToObject0.xyz + normal.y * i.worldToObject1.xyz + normal.z * i.worldToObject2.xyz;
    float handedness = (i.flags & INSTANCE_MIRRORED) != 0u ? -tangent.w : tangent.w;
    tangentWorldOut = vec4(dot(i.objectToWorld0.xyz, tangent.xyz), dot(i.objectToWorld1.xyz, tangent.xyz),
                           dot(i.objectToWorld2.xyz, tangent.xyz), handedness);
    texcoordsOut = texcoords;
    colourOut = colour;
    gl_Position = view.worldToClip * vec4(positionWorldOut, 1.0);
}
