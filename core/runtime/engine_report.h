// Everything that an engine tells at one moment, as a value and as bytes: for a window that is elsewhere.
#pragma once

#include <string>
#include <vector>

#include "core/runtime/engine.h"

namespace tactum {

struct EngineReport {
    DeviceInfo device;
    bool running = false, standsStill = false, realtime = false;
    bool armed = false, deadMan = false, overridesCeiling = false;
    double pace = 1;
    Workspace workspace;
    std::uint64_t publishedAfter = 0;
    std::string trouble, caution, priorityNote; ///< safe to print
    ProxyTelemetry proxy;
    ServoTelemetry servo;
    std::vector<TracePoint> trace; ///< since the report before, oldest first
};

/// As poll() left it, and with what popTrace() gives. Thread: that of the engine's members.
void report(Engine& engine, EngineReport& to);

/// Of the same version of the program, or they are refused. What of the bodies only the next step needs is
/// not there.
std::string bytesOf(const EngineReport& report);
/// Errors: bytes that cannot be those of a report. Whatever they name is within its bounds then. Thread of
/// both: any but real time.
Result<EngineReport> readReport(std::string_view bytes);

} // namespace tactum
