#include "thesis/cost_plot.h"

#include <array>

namespace lampyris::sandbox::thesis {
namespace {

struct Part {
    const char* name;
    const char* figure;
};
constexpr std::array<Part, 4> kParts{{{"direct light, G-buffer", kDirect},
                                      {"photon tracing", kTrace},
                                      {"radiance estimate", kEstimate},
                                      {"between nodes", kBetween}}};

}  // namespace

plot::StackedBars costBars(const std::string& title) {
    plot::StackedBars bars{title, "GPU time of a frame (ms)", {}, {}};
    for (const Part& part : kParts) bars.parts.emplace_back(part.name);
    return bars;
}

plot::Bar costBar(const std::string& label, const std::string& subLabel, const Figures& figures) {
    plot::Bar bar{label, subLabel, {}};
    for (const Part& part : kParts) bar.parts.push_back(figures.at(part.figure).mean);
    return bar;
}

}  // namespace lampyris::sandbox::thesis
