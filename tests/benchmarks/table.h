// The figures as Markdown tables for people and as JSON for the plot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/measure.h"

namespace tactum::bench {

/// What a format of printf makes of its arguments, up to 255 characters.
std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));
/// With a comma after each three digits: 73,440.
std::string grouped(std::size_t number);
/// One line of a table.
std::string line(const std::vector<std::string>& cells);
/// Its first two: names, the first `words` columns to the left, those of numbers to the right.
std::string head(const std::vector<std::string>& names, std::size_t words);

/// Sizes and times, one line for each figures.
std::string speedTable(const std::vector<Figures>& all);
/// How far the proxy is from where it should be; only what was judged.
std::string exactnessTable(const std::vector<Figures>& all);
std::string asJson(const std::vector<Figures>& all);
/// Date, processor, compiler and flags, in one line.
std::string circumstances();

} // namespace tactum::bench
