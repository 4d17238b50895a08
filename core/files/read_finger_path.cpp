#include "core/files/read_finger_path.h"

#include <cmath>

#include "core/base/text.h"
#include "core/files/guarded.h"
#include "core/geometry/soup_builder.h"

namespace tactum {
namespace {

constexpr std::string_view kColumns[] = {"t", "x", "y", "z"};
constexpr double kShortestStep = 1e-7; // s; below it a finger's speed means nothing

/// What some programs write before the first letter of a text.
std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// One field of a row, up to its comma, or to its end for the last one.
std::string_view takeField(std::string_view& row, bool last) {
    const std::size_t comma = last ? std::string_view::npos : row.find(',');
    const std::string_view field = trimmed(row.substr(0, comma));
    row.remove_prefix(comma == std::string_view::npos ? row.size() : comma + 1);
    return field;
}

class PathReader {
public:
    explicit PathReader(const Source& source)
        : source_(source), lines_(withoutByteOrderMark(source.bytes())) {}

    std::vector<FingerPoint> read() {
        std::string_view line;
        lines_.next(line);
        readHeader(line);
        path_.reserve(source_.bytes().size() / 32);
        while (lines_.next(line))
            readRow(line);
        if (path_.empty()) source_.fail("has a header but no rows; record the path again");
        return std::move(path_);
    }

private:
    void readHeader(std::string_view line) {
        for (std::string_view column : kColumns)
            if (takeField(line, column == "z") != column)
                fail("the header must be \"t,x,y,z\"; add it as the first line");
    }

    void readRow(std::string_view line) {
        if (trimmed(line).empty()) {
            blank_ = lines_.number();
            return;
        }
        if (blank_ > 0) source_.failAtLine(blank_, "a blank line inside the path; delete it");
        double values[4];
        for (std::size_t i = 0; i < 4; ++i)
            values[i] = number(line, i);
        if (!path_.empty() && !(values[0] - path_.back().t >= kShortestStep))
            fail("column t: " + std::to_string(values[0]) +
                 " is not 1e-7 s or more after the row before; sort the rows by time");
        path_.push_back({values[0], {values[1], values[2], values[3]}});
    }

    double number(std::string_view& row, std::size_t column) const {
        const std::string_view field = takeField(row, column == 3);
        const std::string where = "column " + std::string(kColumns[column]) + ": ";
        double value = 0;
        if (!parseNumber(field, value))
            fail(where + inQuotes(field) + " is not a number; use a point, not a comma, for decimals");
        const bool usable = column == 0 ? std::isfinite(value) : isCoordinate(value);
        if (!usable)
            fail(where + inQuotes(field) + (column == 0 ? " is not finite" : " is not within 1e6 m") +
                 "; correct it");
        return value;
    }

    [[noreturn]] void fail(const std::string& text) const { source_.failAtLine(lines_.number(), text); }

    const Source& source_;
    Lines lines_;
    std::size_t blank_ = 0; ///< the last blank line; only more of them may follow
    std::vector<FingerPoint> path_;
};

std::vector<FingerPoint> readFrom(const Source& source) {
    return PathReader(source).read();
}

constexpr const char* kNoMemory = "to read it; shorten the path";

} // namespace

Result<std::vector<FingerPoint>> readFingerPath(const std::filesystem::path& file) {
    constexpr std::uint64_t kLargest = std::uint64_t(4) << 30;
    return guarded<std::vector<FingerPoint>>(
        file, kNoMemory, [&] { return readFrom(Source::openFileOrPipe(file, kLargest)); });
}

Result<std::vector<FingerPoint>> readFingerPath(std::string_view text, const std::filesystem::path& where) {
    return guarded<std::vector<FingerPoint>>(where, kNoMemory,
                                             [&] { return readFrom(Source::ofBytes(where, text)); });
}

} // namespace tactum
