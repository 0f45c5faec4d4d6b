#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/place.glsl"
#include "shared/motion.h"
#include "shared/view.h"

layout(set = 0, binding = SLOT_VIEW) uniform ViewBlock { View view; };
layout(set = 0, binding = SLOT_INSTANCES, std430) readonly buffer Instances { GpuInstance instances[]; };
layout(push_constant) uniform Push { MotionDraw drawn; };

layout(location = STREAM_MOTION_POSITION) in vec3 position;
layout(location = STREAM_MOTION_BEFORE) in vec3 positionBefore;

invariant gl_Position;  // as in gbuffer.vert
layout(location = 0) out vec3 motionOut;

void main() {
    GpuInstance i = instances[drawn.instance];
    vec3 positionWorld = placed(position, i.objectToWorld0, i.objectToWorld1, i.objectToWorld2);
    motionOut = placed(positionBefore, drawn.objectToWorldBefore0, drawn.objectToWorldBefore1,
                       drawn.objectToWorldBefore2) - positionWorld;
    gl_Position = view.worldToClip * vec4(positionWorld, 1.0);
}
