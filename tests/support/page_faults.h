// How often a thread of this program had to wait for a page of memory.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace tactum {

/// Page faults so far of the thread with this name, minor and major; nothing when there is no such thread.
inline std::optional<long> pageFaultsOf(const std::string& name) {
    namespace fs = std::filesystem;
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        std::string comm, line;
        std::getline(std::ifstream(task.path() / "comm"), comm);
        if (comm != name) continue;
        std::getline(std::ifstream(task.path() / "stat"), line);
        // After the name in parentheses: state, five numbers, flags, minflt, cminflt, majflt.
        std::istringstream fields(line.substr(line.rfind(')') + 2));
        std::string skip;
        long minor = 0, childMinor = 0, major = 0;
        for (int i = 0; i < 7; ++i)
            fields >> skip;
        fields >> minor >> childMinor >> major;
        return minor + major;
    }
    return {};
}

} // namespace tactum
