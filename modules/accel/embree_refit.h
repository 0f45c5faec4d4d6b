/// \file Embree's own refit of a deforming mesh: what ours is compared with.
#pragma once

#include <memory>
#include <vector>

#include "core/result.h"
#include "math/glm.h"

namespace lampyris::accel {

/// One mesh in a scene of its own, committed once, of RTC_BUILD_QUALITY_REFIT.
class EmbreeRefit {
 public:
    static core::Result<EmbreeRefit> create(const std::vector<glm::vec3>& positions,
                                            const std::vector<uint32_t>& indices);
    ~EmbreeRefit();
    EmbreeRefit(EmbreeRefit&&) noexcept;
    EmbreeRefit& operator=(EmbreeRefit&&) noexcept;

    /// As many positions as there were. \return milliseconds of Embree's commits alone
    double refit(const std::vector<glm::vec3>& positions);

 private:
    struct Parts;
    explicit EmbreeRefit(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace lampyris::accel
