/// \file What every subcommand hands to main.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

#include "core/result.h"

namespace lampyris::sandbox {

/// The subcommand that was called.
struct Command {
    std::function<core::Result<void>()> check;  ///< an Error is a wrong call: exit 2
    std::function<core::Result<void>()> run;    ///< an Error ends the program with 1
};

// Each registers one subcommand, which sets `called` when it is parsed.
void addRender(CLI::App& program, Command& called);
void addReference(CLI::App& program, Command& called);
void addView(CLI::App& program, Command& called);
void addInfo(CLI::App& program, Command& called);
void addCompare(CLI::App& program, Command& called);
void addFlicker(CLI::App& program, Command& called);
void addBench(CLI::App& program, Command& called);

}  // namespace lampyris::sandbox
