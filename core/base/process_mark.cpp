#include "core/base/process_mark.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "core/base/realtime.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

/// The first line of a file of the kernel; empty when there is none.
std::string lineOf(const char* file) {
    std::string line;
    std::ifstream in(file);
    std::getline(in, line);
    return line;
}

std::string linkOf(const char* file) {
    std::error_code fault;
    return fs::read_symlink(file, fault).string();
}

std::string plain(std::string text, std::size_t limit) {
    std::erase_if(text, [](char c) {
        const bool isPlain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        return !isPlain && c != '-' && c != '.';
    });
    return text.substr(0, limit);
}

std::optional<std::uint64_t> numberIn(std::string_view text) {
    std::uint64_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
    return number;
}

/// When a process began; none when there is no such one, or only what its parent has not collected yet.
std::optional<std::uint64_t> beginOf(std::uint64_t pid) {
    std::string line = lineOf(("/proc/" + std::to_string(pid) + "/stat").c_str());
    const std::size_t name = line.rfind(')'); // the name before may hold anything
    if (name == std::string::npos) return std::nullopt;
    std::istringstream rest(line.substr(name + 1));
    const std::vector<std::string> fields(std::istream_iterator<std::string>(rest), {});
    constexpr std::size_t kState = 0, kBegin = 19; // fields 3 and 22 of proc(5)
    if (fields.size() <= kBegin || fields[kState] == "Z" || fields[kState] == "X") return std::nullopt;
    return numberIn(fields[kBegin]);
}

} // namespace

ProcessMark ownMark() {
    assertNotRealtime();
    ProcessMark mark;
    mark.host = plain(lineOf("/proc/sys/kernel/hostname"), 64);
    mark.boot = plain(lineOf("/proc/sys/kernel/random/boot_id"), 8);
    mark.space = plain(linkOf("/proc/self/ns/pid"), 32);
    mark.pid = numberIn(linkOf("/proc/self")).value_or(0);
    mark.began = beginOf(mark.pid).value_or(0);
    return mark;
}

std::string nameOf(const ProcessMark& mark) {
    return mark.host + '_' + mark.boot + '_' + mark.space + '_' + std::to_string(mark.pid) + '_' +
           std::to_string(mark.began);
}

std::optional<ProcessMark> markNamed(std::string_view name) {
    std::vector<std::string> parts(1);
    for (const char c : name)
        if (c == '_')
            parts.emplace_back();
        else
            parts.back() += c;
    if (parts.size() != 5) return std::nullopt;
    const auto pid = numberIn(parts[3]), began = numberIn(parts[4]);
    if (!pid || !began) return std::nullopt;
    return ProcessMark{parts[0], parts[1], parts[2], *pid, *began};
}

bool hasEnded(const ProcessMark& mark, fs::file_time_type lastSign) {
    const ProcessMark own = ownMark();
    const bool sameBoot = mark.host == own.host && mark.boot == own.boot;
    if (sameBoot && mark.space == own.space) return beginOf(mark.pid) != mark.began;
    if (mark.host == own.host && !sameBoot && !mark.host.empty() && !mark.boot.empty()) return true;
    return fs::file_time_type::clock::now() - lastSign > kSilence;
}

} // namespace tactum
