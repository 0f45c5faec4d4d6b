#include "reference/surface_discs.h"

#include <cmath>

namespace lampyris::reference {

SurfaceDiscs::SurfaceDiscs(const std::vector<SmoothGuide>& guides, uint32_t width)
    : guides_(guides), width_(width), height_(static_cast<int>(guides.size() / width)) {
    const int reach = static_cast<int>(kDiscRadii.back());
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const float distance = std::hypot(static_cast<float>(x), static_cast<float>(y));
            for (size_t disc = 0; disc < rings_.size(); ++disc) {
                if (distance > kDiscRadii[disc]) continue;
                if (distance > 0.0f) rings_[disc].emplace_back(x, y);
                break;
            }
        }
}

}  // namespace lampyris::reference
