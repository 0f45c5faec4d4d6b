#include "evaluation/comparison.h"

#include <cmath>

#include "evaluation/flip.h"
#include "evaluation/heat_map.h"
#include "evaluation/mse.h"
#include "evaluation/mssim.h"
#include "evaluation/nrmse.h"
#include "evaluation/rel_mse.h"

namespace lampyris::evaluation {
namespace {

constexpr float kBrightestDifference = 64.0f;  // [chosen] a quarter of the range: errors are small

}  // namespace

core::Result<Comparison> compare(const Picture& image, const Picture& reference) {
    Comparison c;
    TRY(c.mse, mse(image, reference));
    TRY(c.nrmse, nrmse(image, reference));
    TRY(c.mssim, mssim(image, reference));
    TRY(c.flip, flip(image, reference));
    TRY(c.relMse, relMse(image, reference));
    return c;
}

std::array<Figure, 5> figuresOf(const Comparison& c) {
    return {{{"MSE", c.mse.value},
             {"NRMSE", c.nrmse.value},
             {"MSSIM", c.mssim.value},
             {"FLIP", c.flip.value},
             {"relMSE", c.relMse.value}}};
}

core::DisplayImage drawMaps(const Comparison& c) {
    core::Image difference = c.mse.map;
    for (float& value : difference.values) value = std::sqrt(value);
    core::Image dissimilarity = c.mssim.map;
    for (float& value : dissimilarity.values) value = 1.0f - value;
    return sideBySide(
        std::array{heatMap(difference, kBrightestDifference),
                   centred(heatMap(dissimilarity, 1.0f), difference.width, difference.height),
                   heatMap(c.flip.map, 1.0f)});
}

}  // namespace lampyris::evaluation
