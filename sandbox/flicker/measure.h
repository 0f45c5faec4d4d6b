/// \file All figures of one way of drawing; none of them is given alone.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/dynamic_flicker.h"
#include "evaluation/flicker.h"
#include "evaluation/lag.h"
#include "flicker/call.h"
#include "flicker/truth.h"

namespace lampyris::sandbox::flicker {

struct Still {
    evaluation::StaticFlicker flicker;
    std::vector<double> changes;  ///< a frame each
    double mssim = 0.0;           ///< of the time-averaged frame against the reference
};

constexpr std::array<const char*, 3> kLightChanges{"off", "on", "moved"};

struct Row {
    std::string name;
    Options options;
    std::string device;
    Still still, frozen;  ///< with paths of every frame's own, and with the same in all
    /// As kLightChanges. None where there is no light, or the change changes nothing.
    std::array<std::optional<evaluation::Lag>, 3> lags;
    std::optional<evaluation::DynamicFlicker> moving;  ///< none where nothing moves
    evaluation::DynamicFlicker floor;                  ///< of `moving`
};

core::Result<Row> measureRow(const std::string& name, const Options& options, const Call& call,
                             Truths& truths);

}  // namespace lampyris::sandbox::flicker
