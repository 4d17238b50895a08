// What a self-test leaves behind: a profile, a page and a table.
#include <array>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "core/self_test/self_test.h"

namespace tactum {
namespace {

std::string shortNumber(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

/// A name may be whatever a maker's library says.
std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text)
        safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return safe;
}

std::string listOf(const std::string& title, const std::vector<TrialWords>& lines, const std::string& none) {
    std::string html = "<h2>" + title + "</h2>\n";
    if (lines.empty()) return html + "<p>" + none + "</p>\n";
    html += "<ul>\n";
    for (const TrialWords& line : lines)
        html += "<li>" + escaped(line.english()) + "</li>\n";
    return html + "</ul>\n";
}

std::string rowOf(const SelfTestFigure& figure) {
    const std::string error =
        figure.measured.error > 0 ? "&plusmn; " + shortNumber(figure.measured.error) : "";
    return "<tr><td>" + escaped(figure.name.english()) + "</td><td>" + shortNumber(figure.measured.value) +
           "</td><td>" + error + "</td><td>" + escaped(figure.unit) + "</td><td>" +
           (figure.said ? shortNumber(*figure.said) : "") + "</td></tr>\n";
}

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Self-test</title>\n"
    "<style>body{font:15px sans-serif;max-width:48em;margin:2em auto}td,th{text-align:left;padding:0 1em 0 "
    "0}</style></head><body>\n";

} // namespace

std::string profileOfReport(const SelfTestReport& report, const std::string& date) {
    nlohmann::ordered_json figures = nlohmann::ordered_json::object();
    for (const SelfTestFigure& figure : report.figures)
        if (!figure.key.empty())
            figures[figure.key] = {{"value", figure.measured.value},
                                   {"source", "self-test of " + date + ", +- " +
                                                  shortNumber(figure.measured.error) + " " + figure.unit}};
    const nlohmann::ordered_json profile{{"format", "tactum-device"},
                                         {"version", 1},
                                         {"note", "Measured by the self-test on " + date + "."},
                                         {"figures", figures}};
    // A name or a unit that is no UTF-8 is shown with a mark and not refused.
    return profile.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string htmlOfReport(const SelfTestReport& report, const std::string& date) {
    std::string html = kHead;
    html += "<h1>Self-test of " + escaped(report.device.name) + ", " + escaped(date) + "</h1>\n";
    html += listOf("What is wrong", report.faults, "Nothing was found.");
    html += "<h2>What was measured</h2>\n<table><tr><th>figure</th><th>value</th><th>error</th><th>unit</th>"
            "<th>profile of before</th></tr>\n";
    for (const SelfTestFigure& figure : report.figures)
        html += rowOf(figure);
    html += "</table>\n<p>Errors are one standard deviation or the bound of the method. The amplifier's lag "
            "stands in "
            "the delay: where a motion is smaller than the resolution the two cannot be told apart.</p>\n";
    html += listOf("What was left out", report.leftOut, "Nothing.");
    return html + "</body></html>\n";
}

std::string csvOfReport(const SelfTestReport& report) {
    std::string csv = "t,x,y,z,force_x,force_y,force_z,buttons,valid\n";
    std::array<char, 256> line{};
    for (const TrialRow& row : report.rows) {
        std::snprintf(line.data(), line.size(), "%.6f,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%u,%d\n", row.time,
                      row.position.x(), row.position.y(), row.position.z(), row.force.x(), row.force.y(),
                      row.force.z(), row.buttons, int(row.valid));
        csv += line.data();
    }
    return csv;
}

} // namespace tactum
