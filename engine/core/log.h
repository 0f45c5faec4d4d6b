/// \file One line a message on stderr. Standard output belongs to results.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace lampyris::core {

enum class LogLevel { Debug, Info, Warning, Error };

/// Messages under this level are dropped; Info at the start.
void setLogLevel(LogLevel level);

/// Writes one line, "warning: …" for Warning and "error: …" for Error.
void logLine(LogLevel level, const std::string& message);

/// Keeps lines back from now on, until one of the next two ends that.
void holdLog();
/// Writes the lines that were kept back.
void releaseLog();
/// Gives the lines that were kept back instead of writing them.
[[nodiscard]] std::vector<std::string> takeHeldLog();

template <typename... Args>
void logDebug(fmt::format_string<Args...> format, Args&&... args) {
    logLine(LogLevel::Debug, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void logInfo(fmt::format_string<Args...> format, Args&&... args) {
    logLine(LogLevel::Info, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void logWarning(fmt::format_string<Args...> format, Args&&... args) {
    logLine(LogLevel::Warning, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void logError(fmt::format_string<Args...> format, Args&&... args) {
    logLine(LogLevel::Error, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace lampyris::core
