// full: how many tiles each photon's sphere touches. A photon visits only the tiles under its own outline.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bin_photons.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_BIN_COUNTS, std430) writeonly buffer Counts { uint counts[]; };

void main() {
    uint photon = gl_GlobalInvocationID.x;
    if (photon >= params.capacity) return;
    uint count = 0u;
    if (photon < photonCount()) {
        vec3 centre = photonViewDepth(photon);
        ivec2 first, last;
        sphereTiles(centre, params.radius, first, last);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                vec2 depths = bounds[y * int(view.tilesX) + x];
                if (depths.x > depths.y) continue;
                if (sphereTouchesTile(centre, params.radius, tileFrustum(uvec2(x, y), depths))) ++count;
            }
    }
    counts[photon] = count;
}
