#version 460
// target[i] = scale · source[i].x + kOffset
layout(local_size_x = 64) in;
layout(constant_id = 3) const float kOffset = 0.0;
layout(set = 0, binding = 0) uniform samplerBuffer source;
layout(set = 0, binding = 1, r32f) uniform writeonly imageBuffer target;
layout(set = 0, binding = 2) uniform Params { float scale; } params;
void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < imageSize(target))
        imageStore(target, i, vec4(params.scale * texelFetch(source, i).x + kOffset));
}
