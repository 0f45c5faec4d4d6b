/// \file How far long work has come, on a terminal; nothing in a pipe.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace lampyris::sandbox {

/// One line on stderr that is overwritten, and gone at the end.
class Progress {
 public:
    Progress(std::string what, uint64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(uint64_t done);

 private:
    std::string what_;
    uint64_t total_;
    bool onTerminal_;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace lampyris::sandbox
