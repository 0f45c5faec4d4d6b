#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace lampyris::sandbox {
namespace {

constexpr std::chrono::milliseconds kInterval{100};
constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

Progress::Progress(std::string what, uint64_t total)
    : what_(std::move(what)), total_(total), onTerminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (onTerminal_) std::fputs(kClearLine, stderr);
}

void Progress::show(uint64_t done) {
    const auto now = std::chrono::steady_clock::now();
    if (!onTerminal_ || now - last_ < kInterval) return;
    last_ = now;
    fmt::print(stderr, "{}{} {}/{}", kClearLine, what_, done, total_);
    std::fflush(stderr);
}

}  // namespace lampyris::sandbox
