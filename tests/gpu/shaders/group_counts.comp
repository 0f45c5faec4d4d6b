#version 460
// Arguments of an indirect dispatch.
layout(local_size_x = 1) in;
layout(set = 0, binding = 0) writeonly buffer Groups { uint values[]; } groups;
layout(push_constant) uniform Push { uint x; } push;
void main() {
    groups.values[0] = push.x;
    groups.values[1] = 1u;
    groups.values[2] = 1u;
}
