#version 460
// out[i] = 2 in[i] + add
layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer In { uint values[]; } source;
layout(set = 0, binding = 1) writeonly buffer Out { uint values[]; } target;
layout(push_constant) uniform Push { uint count; uint add; } push;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < push.count) target.values[i] = 2u * source.values[i] + push.add;
}
