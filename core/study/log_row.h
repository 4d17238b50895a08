// A row of a log as CSV, and the version of the columns.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/numbers.h"
#include "core/base/vec.h"

namespace tactum {

/// Of the columns of both logs. Another major number is another meaning of one, a higher minor one has more
/// of them. 1.1: what the touch was of, and what was asked of the device; 1.0 had neither.
inline constexpr const char* kStudyLogVersion = "1.1";

/// A row in the making.
class LogRow {
public:
    LogRow& text(std::string_view words) {
        begin();
        if (words.find_first_of(",\"\r\n") == words.npos) {
            row_ += words;
            return *this;
        }
        row_ += '"';
        for (const char c : words) {
            if (c == '"') row_ += '"';
            row_ += c == '\r' || c == '\n' ? ' ' : c; // a row is one line
        }
        row_ += '"';
        return *this;
    }
    LogRow& number(double value) {
        begin();
        appendNumber(row_, value);
        return *this;
    }
    LogRow& vector(const Vec3& value) { return number(value.x()).number(value.y()).number(value.z()); }
    LogRow& whole(std::uint64_t value) {
        return text(std::to_string(value));
    } // 64 bits are more than a double's
    LogRow& none() { return text({}); }
    LogRow& maybe(bool there, double value) { return there ? number(value) : none(); }
    std::string line() const { return row_ + '\n'; }

private:
    void begin() {
        if (!first_) row_ += ',';
        first_ = false;
    }
    std::string row_;
    bool first_ = true;
};

} // namespace tactum
