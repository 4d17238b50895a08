// Everything that an engine tells at one moment, as a value and as bytes: for a window that is elsewhere.
#pragma once

#include <string>
#include <vector>

#include "core/runtime/engine.h"

namespace tactum {

class LocalEngine;

/// Of one hand.
struct HandReport {
    DeviceInfo device;
    bool standsStill = false, armed = false, deadMan = false, overridesCeiling = false;
    Workspace workspace;
    std::string trouble, caution; ///< safe to print
    TouchTelemetry touch;
    ServoTelemetry servo;
    std::vector<TracePoint> trace; ///< since the report before, oldest first
};

struct EngineReport {
    bool running = false, realtime = false;
    double pace = 1;
    std::uint64_t publishedAfter = 0;
    std::string priorityNote; ///< safe to print
    WorldTelemetry world;
    std::vector<HandReport> hands; ///< from 1 to kMaxHands
};

/// As poll() left it, and with what popTrace() gives of each hand. Thread: that of the engine's members.
void report(LocalEngine& engine, EngineReport& to);

/// Of the same version of the program, or they are refused. What only the next step needs, of bodies and of
/// what a touch pushes them with, is not there.
std::string bytesOf(const EngineReport& report);
/// Errors: bytes that cannot be those of a report. Whatever they name is within its bounds then. Thread of
/// both: any but real time.
Result<EngineReport> readReport(std::string_view bytes);

} // namespace tactum
