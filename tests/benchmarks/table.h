// The figures as Markdown tables for people and as JSON for the plot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/measure.h"

namespace tactum::bench {

/// Sizes and times, one line for each figures.
std::string speedTable(const std::vector<Figures>& all);
/// How far the proxy is from where it should be; only what was judged.
std::string exactnessTable(const std::vector<Figures>& all);
std::string asJson(const std::vector<Figures>& all);
/// Date, processor, compiler and flags, in one line.
std::string circumstances();

} // namespace tactum::bench
