/// \file overlay: Dear ImGui's triangles over the picture.
///   in      this frame's draw lists, the font, a picture that panels show      out   the picture
///   shader  overlay/panels.vert, panels.frag
#pragma once

#include "core/result.h"
#include "gpu/image.h"
#include "graph/frame.h"

struct ImDrawData;

namespace lampyris::overlay {

/// Of ImGui's atlas, which must be built.
core::Result<gpu::Image> makeFont(gpu::Device& device);

/// What panels show the picture by; any other texture is the font.
[[nodiscard]] void* pictureTexture();  ///< an ImTextureID

/// \param shown    8-bit display values; drawn over
/// \param picture  what pictureTexture() shows; invalid: the font
[[nodiscard]] graph::Image addPanels(graph::Frame& frame, const ImDrawData& lists,
                                     const gpu::Image& font, graph::Image picture,
                                     graph::Image shown);

}  // namespace lampyris::overlay
