#version 460
layout(location = 0) in vec3 position;
layout(push_constant) uniform Push { vec4 colour; vec4 shift; } push;
layout(location = 0) out vec4 colour;
void main() {
    gl_Position = vec4(position + push.shift.xyz, 1.0);
    colour = push.colour;
}
