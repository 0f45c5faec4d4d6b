#include "evaluation/rel_mse.h"

namespace lampyris::evaluation {
namespace {

// [eq] Rousselle et al. 2011: keeps black from weighing without bound.
constexpr double kEpsilon = 0.01;

}  // namespace

core::Result<Measure> relMse(const Picture& image, const Picture& reference) {
    TRY_VOID(checkComparable(image, reference));
    Measure measure{0.0, core::Image(image.linear.width, image.linear.height, 1)};
    double total = 0.0;
    for (size_t p = 0; p < measure.map.values.size(); ++p) {
        double pixel = 0.0;
        for (size_t i = p * 3; i < p * 3 + 3; ++i) {
            const double wanted = reference.linear.values[i];
            const double difference = image.linear.values[i] - wanted;
            pixel += difference * difference / (wanted * wanted + kEpsilon);
        }
        measure.map.values[p] = static_cast<float>(pixel / 3.0);
        total += pixel;
    }
    measure.value = total / static_cast<double>(image.linear.values.size());
    return measure;
}

}  // namespace lampyris::evaluation
