#include "core/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>

namespace lampyris::core {
namespace {

spdlog::level::level_enum spdlogLevel(LogLevel level) {
    switch (level) {
        case LogLevel::Debug:
            return spdlog::level::debug;
        case LogLevel::Info:
            return spdlog::level::info;
        case LogLevel::Warning:
            return spdlog::level::warn;
        case LogLevel::Error:
            return spdlog::level::err;
    }
    return spdlog::level::info;
}

const char* prefix(LogLevel level) {
    switch (level) {
        case LogLevel::Warning:
            return "warning: ";
        case LogLevel::Error:
            return "error: ";
        default:
            return "";
    }
}

spdlog::logger& logger() {
    static const std::shared_ptr<spdlog::logger> instance = [] {
        auto sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
        sink->set_pattern("%v");
        auto made = std::make_shared<spdlog::logger>("lampyris", sink);
        made->set_level(spdlog::level::info);
        made->flush_on(spdlog::level::debug);
        return made;
    }();
    return *instance;
}

struct Held {
    std::mutex mutex;
    bool holding = false;
    std::vector<std::pair<LogLevel, std::string>> lines;
};

Held& held() {
    static Held instance;
    return instance;
}

std::vector<std::pair<LogLevel, std::string>> endHolding() {
    const std::lock_guard lock(held().mutex);
    held().holding = false;
    return std::exchange(held().lines, {});
}

bool keepBack(LogLevel level, const std::string& message) {
    const std::lock_guard lock(held().mutex);
    if (held().holding) held().lines.emplace_back(level, message);
    return held().holding;
}

}  // namespace

void holdLog() {
    const std::lock_guard lock(held().mutex);
    held().holding = true;
}

void releaseLog() {
    for (const auto& [level, message] : endHolding()) logLine(level, message);
}

std::vector<std::string> takeHeldLog() {
    std::vector<std::string> messages;
    for (auto& [level, message] : endHolding()) messages.push_back(std::move(message));
    return messages;
}

void setLogLevel(LogLevel level) {
    logger().set_level(spdlogLevel(level));
}

void logLine(LogLevel level, const std::string& message) {
    if (!logger().should_log(spdlogLevel(level)) || keepBack(level, message)) return;
    logger().log(spdlogLevel(level), "{}{}", prefix(level), message);
}

}  // namespace lampyris::core
