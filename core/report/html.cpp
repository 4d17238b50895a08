#include "core/report/html.h"

#include <charconv>
#include <numbers>

#include "core/base/text.h"
#include "core/presets/base64.h"

namespace tactum {

namespace {

constexpr int kDigits = 6;

std::string row(const char* first, const char* others, const Row& cells) {
    std::string text = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string cell = i == 0 ? first : others, name = cell.substr(0, cell.find(' '));
        text += "<" + cell + ">" + escaped(cells[i]) + "</" + name + ">";
    }
    return text + "</tr>\n";
}

} // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : printable(text, kLongestName)) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&#39;";
            break;
        default:
            safe += c;
        }
    }
    return safe;
}

std::string heading(int level, std::string_view text) {
    const std::string tag = "h" + std::to_string(level) + ">";
    return "<" + tag + escaped(text) + "</" + tag + "\n";
}

std::string paragraph(std::string_view text) {
    return "<p>" + escaped(text) + "</p>\n";
}

std::string table(const Row& head, const std::vector<Row>& rows) {
    if (rows.empty()) return {};
    std::string text = "<table border=\"1\" cellspacing=\"0\" cellpadding=\"4\">\n<thead>" +
                       row("th scope=\"col\"", "th scope=\"col\"", head) + "</thead>\n<tbody>\n";
    for (const Row& cells : rows)
        text += row("th scope=\"row\"", "td", cells);
    return text + "</tbody>\n</table>\n";
}

std::string picture(std::string_view mimeType, std::string_view bytes, std::string_view alt, int width,
                    int height) {
    const std::string high = height > 0 ? "\" height=\"" + std::to_string(height) : "";
    return "<p class=\"picture\"><img width=\"" + std::to_string(width) + high + "\" alt=\"" + escaped(alt) +
           "\" src=\"data:" + std::string(mimeType) + ";base64," + base64Of(bytes) + "\"></p>\n";
}

std::string readable(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, kDigits).ptr};
}

Quantity quantity(double value, std::string_view unit) {
    if (unit == "m") return {readable(1e3 * value), "mm"};
    if (unit == "rad") return {readable(value * 180 / std::numbers::pi), "\u00b0"};
    return {readable(value), std::string(unit)};
}

} // namespace tactum
