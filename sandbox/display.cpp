#include "display.h"

#include <cmath>

#include "sandbox/shaders.h"
#include "shared/display.h"

namespace lampyris::sandbox {

graph::Image addDisplay(graph::Frame& frame, graph::Image radiance,
                        const core::DisplayTransform& transform) {
    const graph::Extent size = frame.desc(radiance).extent;
    const bool filmic = transform.tonemap == core::Tonemap::Filmic;
    shared::DisplayParams params{};
    params.gain = std::exp2(transform.exposureEv);
    params.tonemap = filmic ? shared::DISPLAY_FILMIC : shared::DISPLAY_CLIP;
    auto node = frame.compute("composite/display", shaders::display);
    node.sample(shared::SLOT_DISPLAY_RADIANCE, radiance).push(params);
    const graph::Image shown = node.write(shared::SLOT_DISPLAY_SHOWN,
                                          frame.image("shown", {graph::Format::RGBA8Unorm, size}));
    node.dispatchOver(size);
    return shown;
}

}  // namespace lampyris::sandbox
