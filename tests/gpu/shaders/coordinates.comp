#version 460
// Each texel holds its own coordinates.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform writeonly image2D target;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(target)))) imageStore(target, pixel, vec4(pixel, 0.0, 1.0));
}
