#include "execute/chrome_trace.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lampyris::execute {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeviceRow = 1;
constexpr int kCpuRow = 2;
constexpr double kMicroseconds = 1000.0;  // a millisecond

Json rowName(int row, const char* name) {
    return {
        {"name", "thread_name"}, {"ph", "M"}, {"pid", 1}, {"tid", row}, {"args", {{"name", name}}}};
}

/// Adds an event and gives the time at which it ends.
double addEvent(Json& events, int row, const std::string& name, double begin, double milliseconds) {
    const double duration = milliseconds * kMicroseconds;
    events.push_back(
        {{"name", name}, {"ph", "X"}, {"pid", 1}, {"tid", row}, {"ts", begin}, {"dur", duration}});
    return begin + duration;
}

}  // namespace

void ChromeTrace::add(const FrameStatistics& frame) {
    frames_.push_back(frame);
}

std::string ChromeTrace::text() const {
    Json events = Json::array({rowName(kDeviceRow, "device"), rowName(kCpuRow, "cpu: recording")});
    double begin = 0.0;
    for (const FrameStatistics& frame : frames_) {
        double device = begin;
        double cpu = begin;
        for (const NodeTime& node : frame.nodes) {
            device = addEvent(events, kDeviceRow, node.name, device, node.gpuMilliseconds);
            cpu = addEvent(events, kCpuRow, node.name, cpu, node.cpuRecordMilliseconds);
        }
        begin = std::max({device, cpu, begin + frame.gpuMilliseconds * kMicroseconds});
    }
    const Json trace{{"traceEvents", events}, {"displayTimeUnit", "ms"}};
    return trace.dump(1) + "\n";
}

}  // namespace lampyris::execute
