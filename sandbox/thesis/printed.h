/// \file What the Thesis printed (Jimenez Kwast 2016, chapter 6 and appendix B): its measurements
/// on a GTX 760 at 1920x1080, means over 1000 frames. MSE is of 8-bit values; NRMSE is the root of
/// it over 206.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace lampyris::sandbox::thesis {

struct PrintedRow {
    uint32_t paths, stored;  ///< emitted, and photons kept of them
    double radiusMetres;
    double milliseconds, stddev;  ///< of a frame
    double mse, nrmse, mssim;
};

[[nodiscard]] std::span<const PrintedRow> table61();  ///< parameter scaling
[[nodiscard]] std::span<const PrintedRow> table62();  ///< a fixed budget of about 11.4 ms

struct PrintedSystem {
    const char* name;
    double milliseconds, mse, nrmse, mssim;
};

[[nodiscard]] std::span<const PrintedSystem> table63();  ///< system comparison

constexpr std::array<double, 5> kRadiiMetres{0.25, 0.5, 1.0, 1.5, 2.0};

struct PrintedCost {
    double milliseconds, stddev;
};

struct PrintedCosts {
    uint32_t paths, stored;
    std::array<PrintedCost, kRadiiMetres.size()> costs;  ///< a radius each
};

struct PrintedScene {
    const char* table;    ///< "B.1"
    const char* name;     ///< as the Thesis calls it
    const char* builtin;  ///< the scene that stands for it here
    std::array<PrintedCosts, 5> rows;
};

[[nodiscard]] std::span<const PrintedScene> tablesB();  ///< scene complexity

}  // namespace lampyris::sandbox::thesis
