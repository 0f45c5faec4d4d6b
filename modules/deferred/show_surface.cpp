#include "deferred/show_surface.h"

#include <array>
#include <string>

#include "deferred/shaders.h"
#include "shared/direct.h"

namespace lampyris::deferred {

void publishSurface(graph::Frame& frame, const Surface& surface) {
    struct Shown {
        const char* name;
        uint32_t what;
    };
    constexpr std::array kShown{
        Shown{"albedo", shared::SHOW_ALBEDO}, Shown{"normal", shared::SHOW_NORMAL},
        Shown{"position", shared::SHOW_POSITION}, Shown{"depth", shared::SHOW_DEPTH},
        Shown{"emission", shared::SHOW_EMISSION}};
    const graph::Extent size{surface.view.width, surface.view.height};
    for (const Shown& shown : kShown) {
        auto node = frame.compute(std::string("show/") + shown.name, shaders::showSurface);
        bindSurfaceMaterial(node, surface);
        node.specialise(0, shown.what);
        const graph::Image image = node.write(
            shared::SLOT_SHOWN, frame.image(shown.name, {graph::Format::RGBA32Float, size}));
        node.dispatchOver(size);
        frame.publish(shown.name, image);
    }
}

}  // namespace lampyris::deferred
