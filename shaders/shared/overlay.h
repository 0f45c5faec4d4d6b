// Slots and parameters of what lies over the picture.
#ifndef LAMPYRIS_SHARED_OVERLAY_H
#define LAMPYRIS_SHARED_OVERLAY_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

// overlay
LAMPYRIS_SLOT(SLOT_PANEL_VERTICES, 0u);   // PANEL_VERTEX_WORDS words each: position, uv, RGBA8
LAMPYRIS_SLOT(SLOT_PANEL_INDICES, 1u);    // of vertices, from PanelDraw.firstVertex on
LAMPYRIS_SLOT(SLOT_PANEL_FONT, 2u);
LAMPYRIS_SLOT(SLOT_PANEL_PICTURE, 3u);    // the image that is looked at
LAMPYRIS_SLOT(PANEL_VERTEX_WORDS, 5u);

LAMPYRIS_SLOT(PANEL_SAMPLES_FONT, 0u);
LAMPYRIS_SLOT(PANEL_SAMPLES_PICTURE, 1u);

struct PanelDraw {
    vec2 scale;        // pixels to clip space
    vec2 offset;
    uint firstIndex;
    uint firstVertex;
    uint samples;      // PANEL_SAMPLES_…
    uint pad0;
};

// overlay/look
LAMPYRIS_SLOT(SLOT_LOOK_SOURCE, 0u);      // any image
LAMPYRIS_SLOT(SLOT_LOOK_SHOWN, 1u);       // RGBA8, what is shown of it
LAMPYRIS_SLOT(SLOT_LOOK_FINDINGS, 2u);    // LookFindings
LAMPYRIS_SLOT(LOOK_THREADS, 8u);          // an axis
LAMPYRIS_SLOT(LOOK_BINS, 64u);            // of the histogram, even steps of what is shown
LAMPYRIS_SLOT(LOOK_CHANNELS, 4u);
LAMPYRIS_SLOT(LOOK_COLOUR, 4u);           // LookParams.channel: red, green and blue together
LAMPYRIS_SLOT(LOOK_NUMBERED, 5u);         // whole numbers, each in a colour of its own

struct LookParams {
    float offset;      // shown = (value − offset) · gain
    float gain;
    uint channel;      // 0 to 3, or LOOK_COLOUR, LOOK_NUMBERED
    uint encode;       // 1: linear light, to be encoded as sRGB
    uint layer;
    uint cursorX;      // texel of the source under the cursor; anything outside: none
    uint cursorY;
    uint channels;     // that the source has, from red on; absent ones are not counted
};

// Of all texels, also where fewer are shown.
struct LookFindings {
    vec4 underCursor;
    uvec4 bitsUnderCursor; // of images of whole numbers
    uint leastInverted;    // over the channels that are shown: ~ of its ordered bits; 0: none is finite
    uint most;             // ordered bits
    uint notFinite;        // texels
    uint pad0;
    uint bins[256];        // LOOK_CHANNELS by LOOK_BINS
};

// overlay/photons, overlay/paths
LAMPYRIS_SLOT(SLOT_MARK_PHOTONS, 0u);     // PackedPhoton[]
LAMPYRIS_SLOT(SLOT_MARK_OFFSETS, 1u);     // first photon a path, then their total
LAMPYRIS_SLOT(MARK_BY_POWER, 0u);
LAMPYRIS_SLOT(MARK_BY_BOUNCE, 1u);

struct MarkParams {
    uint pathCount;
    uint capacity;     // photons
    uint colouring;    // MARK_BY_…
    float brightness;  // a watt's, where colours go by power
    float radiusPixels;
    float width, height; // pixels
    uint most;         // photons, and paths, that are drawn
};

// overlay/boxes
LAMPYRIS_SLOT(SLOT_BOX_NODES, 0u);        // the BVH's, texels RGBA32Uint
LAMPYRIS_SLOT(SLOT_BOX_ROOT, 1u);         // GpuBvhRoot

struct BoxParams {
    uint level;        // below the root, from 1; what ends above it is left out
};

// overlay/heat
LAMPYRIS_SLOT(SLOT_HEAT_MEAN, 0u);        // a = frames in the mean
LAMPYRIS_SLOT(SLOT_HEAT_RANGES, 1u);      // uvec2 a tile, the second is what is counted
LAMPYRIS_SLOT(SLOT_HEAT_SHOWN, 2u);       // the picture, drawn over

struct HeatParams {
    float most;        // what is shown as white
    float opacity;
    uint tilesX;
    uint divisor;      // pixels a texel of the mean, an axis
};

// overlay/truth
LAMPYRIS_SLOT(SLOT_TRUTH_WORDS, 0u);      // RGBA8, row by row
LAMPYRIS_SLOT(SLOT_TRUTH_SHOWN, 1u);

LAMPYRIS_SHARED_END
#endif
