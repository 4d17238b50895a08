#include "tests/benchmarks/table.h"

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

namespace tactum::bench {

namespace {

std::string microseconds(double ns) {
    return text(ns < 99950 ? "%.2f" : "%.0f", ns / 1000);
}

// The model of the processor as Linux says it.
std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string row; std::getline(info, row);)
        if (row.starts_with("model name")) return row.substr(row.find(':') + 2);
    return "unknown processor";
}

} // namespace

std::string text(const char* format, ...) {
    char buffer[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    return buffer;
}

std::string line(const std::vector<std::string>& cells) {
    std::string all = "|";
    for (const std::string& cell : cells)
        all += " " + cell + " |";
    return all + "\n";
}

std::string head(const std::vector<std::string>& names, std::size_t words) {
    std::vector<std::string> rule(names.size(), "--:");
    std::fill(rule.begin(), rule.begin() + std::ptrdiff_t(words), ":--");
    return line(names) + line(rule);
}

std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3; i -= 3)
        digits.insert(i - 3, ",");
    return digits;
}

std::string speedTable(const std::vector<Figures>& all) {
    std::string table = head({"mesh", "feel", "triangles", "load s", "build s", "bytes/tri", "mean us",
                              "median us", "p99 us", "p99.9 us", "max us", "rounds", "instructions"},
                             2);
    for (const Figures& f : all)
        table += line({f.mesh, f.effect, grouped(f.triangles), text("%.3f", f.loadSeconds),
                       text("%.3f", f.buildSeconds), text("%.0f", f.bytesPerTriangle),
                       microseconds(f.update.mean), microseconds(double(f.update.median)),
                       microseconds(double(f.update.p99)), microseconds(double(f.update.p999)),
                       microseconds(double(f.update.max)), text("%.2f", f.rounds),
                       f.instructions ? grouped(std::size_t(*f.instructions)) : std::string("-")});
    return table;
}

std::string exactnessTable(const std::vector<Figures>& all) {
    std::string table = head({"mesh", "rows", "over 1 mm off", "over 10 um off", "worst um",
                              "smallest clearance nm", "deepest mm", "rows inside"},
                             1);
    for (const Figures& f : all)
        if (const auto& e = f.exactness)
            table += line({f.mesh, grouped(e->rows), grouped(e->farRows), grouped(e->offRows),
                           text("%.3f", e->worst * 1e6), text("%+.2f", e->smallestClearance * 1e9),
                           text("%.2f", e->deepest * 1e3),
                           e->closed ? grouped(e->insideRows) : std::string("open")});
    return table;
}

std::string asJson(const std::vector<Figures>& all) {
    nlohmann::json rows = nlohmann::json::array();
    for (const Figures& f : all)
        rows.push_back({{"mesh", f.mesh},
                        {"feel", f.effect},
                        {"triangles", f.triangles},
                        {"load_s", f.loadSeconds},
                        {"build_s", f.buildSeconds},
                        {"bytes_per_triangle", f.bytesPerTriangle},
                        {"mean_us", f.update.mean / 1000},
                        {"median_us", double(f.update.median) / 1000},
                        {"p999_us", double(f.update.p999) / 1000},
                        {"max_us", double(f.update.max) / 1000}});
    return rows.dump(2) + "\n";
}

std::string circumstances() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char day[16];
    std::strftime(day, sizeof day, "%Y-%m-%d", std::gmtime(&now));
    return text("%s, %s, %u cores, g++ %s, %s", day, processor().c_str(), std::thread::hardware_concurrency(),
                __VERSION__, TACTUM_BENCH_FLAGS);
}

} // namespace tactum::bench
