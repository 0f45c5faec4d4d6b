#version 460
// current = previous + 1
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D previous;
layout(set = 0, binding = 1, r32f) uniform writeonly image2D current;
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(current))))
        imageStore(current, pixel, texelFetch(previous, pixel, 0) + 1.0);
}
