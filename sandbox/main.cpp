// The program `lampyris`: exit code 0; 1 with one line that names what was wrong; 2 for a wrong
// call.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "command.h"
#include "core/log.h"

namespace {

using namespace lampyris;

constexpr int kFailed = 1;
constexpr int kWrongCall = 2;

int wrongCall(const CLI::App& app, std::string line) {
    const size_t end = line.find('\n');
    if (end != std::string::npos) line.resize(end);
    const CLI::App* called = &app;
    while (!called->get_subcommands().empty()) called = called->get_subcommands().front();
    const std::string command = called == &app ? "lampyris" : "lampyris " + called->get_name();
    fmt::print(stderr, "error: {} (see {} --help)\n", line, command);
    return kWrongCall;
}

/// One line: the error, and what the first warning before it told.
int fail(const core::Error& error, const std::vector<std::string>& warnings) {
    std::string line = error.message;
    if (!warnings.empty()) line += fmt::format(" ({})", warnings.front());
    std::replace(line.begin(), line.end(), '\n', ' ');
    core::logError("{}", line);
    return kFailed;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Real-time global illumination by photon mapping."};
    app.name("lampyris");
    app.require_subcommand(1);
    sandbox::Command called;
    sandbox::addRender(app, called);
    sandbox::addReference(app, called);
    sandbox::addView(app, called);
    sandbox::addCompare(app, called);
    sandbox::addFlicker(app, called);
    sandbox::addBench(app, called);
    sandbox::addInfo(app, called);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);
        const bool unknown = app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-';
        return wrongCall(app,
                         unknown ? fmt::format("there is no subcommand '{}'", argv[1]) : e.what());
    }
    if (called.check) {
        const auto checked = called.check();
        if (!checked.ok()) return wrongCall(app, checked.error().message);
    }
    // Warnings are held back until the first frame, so that a failure is one line.
    core::holdLog();
    const auto result = called.run();
    if (!result.ok()) return fail(result.error(), core::takeHeldLog());
    core::releaseLog();
    return 0;
}
