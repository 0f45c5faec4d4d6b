#include "evaluation/measures.h"

#include <array>

#include "evaluation/flip.h"
#include "evaluation/mse.h"
#include "evaluation/mssim.h"
#include "evaluation/nrmse.h"
#include "evaluation/rel_mse.h"

namespace lampyris::evaluation {

std::span<const NamedMeasure> allMeasures() {
    static constexpr std::array<NamedMeasure, 5> kAll{
        {{"MSE", mse}, {"NRMSE", nrmse}, {"MSSIM", mssim}, {"FLIP", flip}, {"relMSE", relMse}}};
    return kAll;
}

}  // namespace lampyris::evaluation
