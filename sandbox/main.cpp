// The program `lampyris`: exit code 0; 1 with one line that names what was wrong; 2 for a wrong
// call.
#include <fmt/format.h>

#include <cstdio>

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

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Real-time global illumination by photon mapping."};
    app.name("lampyris");
    app.require_subcommand(1);
    sandbox::Command called;
    sandbox::addRender(app, called);
    sandbox::addView(app, called);
    sandbox::addBench(app, called);
    sandbox::addInfo(app, called);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return e.get_exit_code() == 0 ? app.exit(e) : wrongCall(app, e.what());
    }
    if (called.check) {
        const auto checked = called.check();
        if (!checked.ok()) return wrongCall(app, checked.error().message);
    }
    const auto result = called.run();
    if (result.ok()) return 0;
    core::logError("{}", result.error().message);
    return kFailed;
}
