// Warps from the unit square to directions.
#ifndef LAMPYRIS_LIB_SAMPLING
#define LAMPYRIS_LIB_SAMPLING

const float kPi = 3.14159265358979;

// Uniform on the unit sphere [Thesis eq. 5.1, 5.2].
vec3 sampleSphere(vec2 xi) {
    float z = 2.0 * xi.y - 1.0;
    float radius = sqrt(max(0.0, 1.0 - z * z));
    float phi = 2.0 * kPi * xi.x;
    return vec3(radius * cos(phi), radius * sin(phi), z);
}

// Uniform on the unit disk [Thesis eq. 5.3].
vec2 sampleDisk(vec2 xi) {
    float phi = 2.0 * kPi * xi.y;
    return sqrt(xi.x) * vec2(cos(phi), sin(phi));
}

// Two tangents of a unit vector, without a branch on its direction (Duff et al. 2017).
void tangents(vec3 n, out vec3 t, out vec3 b) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float c = n.x * n.y * a;
    t = vec3(1.0 + s * n.x * n.x * a, s * c, -s * n.x);
    b = vec3(c, s + n.y * n.y * a, -n.y);
}

// Cosine-weighted about n [Thesis eq. 5.4, Malley]: pdf = cos/pi.
vec3 sampleCosine(vec3 n, vec2 xi) {
    vec3 t, b;
    tangents(n, t, b);
    vec2 disk = sampleDisk(xi);
    return normalize(disk.x * t + disk.y * b + sqrt(max(0.0, 1.0 - xi.x)) * n);
}

// Uniform in the cone about axis whose half-angle has this cosine.
vec3 sampleCone(vec3 axis, float cosHalfAngle, vec2 xi) {
    vec3 t, b;
    tangents(axis, t, b);
    float z = 1.0 - xi.x * (1.0 - cosHalfAngle);
    float radius = sqrt(max(0.0, 1.0 - z * z));
    float phi = 2.0 * kPi * xi.y;
    return normalize(radius * (cos(phi) * t + sin(phi) * b) + z * axis);
}

#endif
