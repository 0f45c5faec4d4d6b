#version 460
layout(location = 0) in vec4 colour;
layout(location = 0) out vec4 colourOut;
layout(location = 1) out uint idOut;
layout(set = 0, binding = 0) readonly buffer Tints { vec4 values[]; } tints;
void main() {
    colourOut = colour * tints.values[0];
    idOut = 7u;
}
