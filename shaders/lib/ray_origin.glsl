// Where a ray from a pixel's surface begins.
#ifndef LAMPYRIS_LIB_RAY_ORIGIN
#define LAMPYRIS_LIB_RAY_ORIGIN

// Clear of the surface by more than the depth buffer's and the triangles' rounding.
vec3 clearOf(vec3 position, vec3 normal, float viewDepth) {
    return position + normal * (2e-4 * viewDepth + 1e-5 * length(position));
}

#endif
