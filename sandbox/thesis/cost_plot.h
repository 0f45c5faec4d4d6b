/// \file Stacked bars of what a frame's time goes to, as the Thesis' figures 6.3 and B.1.
#pragma once

#include <string>

#include "plot/stacked_bars.h"
#include "thesis/figures.h"

namespace lampyris::sandbox::thesis {

/// Without bars yet.
[[nodiscard]] plot::StackedBars costBars(const std::string& title);
[[nodiscard]] plot::Bar costBar(const std::string& label, const std::string& subLabel,
                                const Figures& figures);

}  // namespace lampyris::sandbox::thesis
