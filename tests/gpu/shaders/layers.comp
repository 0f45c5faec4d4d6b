#version 460
// The first texel of each layer.
layout(local_size_x = 1) in;
layout(set = 0, binding = 0) uniform sampler2DArray layers;
layout(set = 0, binding = 1) writeonly buffer Out { vec4 values[]; } target;
void main() {
    int layer = int(gl_GlobalInvocationID.x);
    target.values[layer] = texelFetch(layers, ivec3(1, 1, layer), 0);
}
