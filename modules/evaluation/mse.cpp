#include "evaluation/mse.h"

namespace lampyris::evaluation {

core::Result<Measure> mse(const Picture& image, const Picture& reference) {
    TRY_VOID(checkComparable(image, reference));
    const core::DisplayImage& a = image.display;
    const core::DisplayImage& b = reference.display;
    Measure measure{0.0, core::Image(a.width, a.height, 1)};
    int64_t total = 0;
    for (size_t p = 0; p < measure.map.values.size(); ++p) {
        int64_t squares = 0;
        for (size_t i = p * 3; i < p * 3 + 3; ++i) {
            const int64_t difference = int64_t{a.values[i]} - int64_t{b.values[i]};
            squares += difference * difference;
        }
        measure.map.values[p] = static_cast<float>(squares) / 3.0f;
        total += squares;
    }
    measure.value = static_cast<double>(total) / static_cast<double>(a.values.size());
    return measure;
}

}  // namespace lampyris::evaluation
