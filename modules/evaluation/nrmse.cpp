#include "evaluation/nrmse.h"

#include <algorithm>
#include <cmath>

#include "evaluation/mse.h"

namespace lampyris::evaluation {

core::Result<Measure> nrmse(const Picture& image, const Picture& reference) {
    TRY(Measure measure, mse(image, reference));
    const auto& values = reference.display.values;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double range = *most - *least;
    const auto share = [range](double squared) {
        return squared == 0.0 ? 0.0 : std::sqrt(squared) / range;
    };
    measure.value = share(measure.value);
    for (float& value : measure.map.values) value = static_cast<float>(share(value));
    return measure;
}

}  // namespace lampyris::evaluation
