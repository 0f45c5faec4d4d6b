// From where the surface is to where it was, metres in world space; a = 1.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/motion.h"

layout(location = 0) in vec3 motion;
layout(location = TARGET_MOTION) out vec4 motionOut;

// The largest half is 65504; what was nowhere counts as that far off, so that no history is found there.
const float FAR = 65000.0;

void main() {
    bool somewhere = dot(motion, motion) < FAR * FAR;
    motionOut = vec4(somewhere ? motion : vec3(FAR), 1.0);
}
