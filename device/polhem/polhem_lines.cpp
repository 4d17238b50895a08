#include "device/polhem/polhem_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/text.h"

namespace tactum {
namespace {

constexpr double kFarthest = 0.6;    ///< m, from the middle of the workspace: the arm is 0.3 m long
constexpr int kMostCounts = 1 << 20; ///< of an encoder: no arm turns so far

template <std::size_t Count>
std::optional<std::array<double, Count>> numbersIn(std::string_view line) noexcept {
    Fields fields(line);
    std::array<double, Count> numbers{};
    for (double& number : numbers)
        if (!parseNumber(fields.next(), number)) return std::nullopt;
    return fields.rest().empty() ? std::optional(numbers) : std::nullopt;
}

} // namespace

std::optional<PolhemPlace> placeIn(std::string_view line) noexcept {
    const auto numbers = numbersIn<8>(line);
    if (!numbers) return std::nullopt;
    PolhemPlace place{.position = 1e-3 * Vec3((*numbers)[1], (*numbers)[2], (*numbers)[0]), .angles = {}};
    if (!(place.position.norm() <= kFarthest)) return std::nullopt;
    std::copy_n(numbers->begin() + 3, 4, place.angles.begin());
    return place;
}

std::optional<PolhemCounts> countsIn(std::string_view line) noexcept {
    line = trimmed(line);
    if (!line.starts_with('[') || !line.ends_with(']')) return std::nullopt;
    std::array<int, 8> numbers{};
    const char* at = line.data();
    const char* const end = line.data() + line.size() - 1;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        ++at; // past the bracket or the comma
        const auto [next, error] = std::from_chars(at, end, numbers[i]);
        if (error != std::errc() || (i + 1 < numbers.size() ? next == end || *next != ',' : next != end))
            return std::nullopt;
        at = next;
    }
    PolhemCounts counts{.model = numbers[0], .encoders = {}, .error = numbers[7]};
    std::copy_n(numbers.begin() + 1, 6, counts.encoders.begin());
    for (const int encoder : counts.encoders)
        if (encoder < -kMostCounts || encoder > kMostCounts) return std::nullopt;
    return counts;
}

bool isOfPlaces(std::string_view line) noexcept {
    return numbersIn<7>(line) || numbersIn<8>(line);
}

void PolhemLine::add(std::string_view text) noexcept {
    size_ += text.copy(text_.data() + size_, text_.size() - size_);
}

void PolhemLine::addThousandths(double value) noexcept {
    const long number = std::isfinite(value) ? std::lround(1000 * std::clamp(value, -30.0, 30.0)) : 0;
    const auto written = std::to_chars(text_.data() + size_, text_.data() + text_.size(), number);
    size_ = std::size_t(written.ptr - text_.data());
}

void PolhemLine::fill(char with, std::size_t size) noexcept {
    for (; size_ < size; ++size_)
        text_[size_] = with;
}

/// The board's buffer holds 64 bytes, and the maker's programs fill it.
PolhemLine forceLine(const Vec3& force) noexcept {
    PolhemLine line;
    for (const double along : {force.z(), force.x(), force.y()}) {
        line.addThousandths(along);
        line.add(" ");
    }
    line.add("2 0 0 0");
    line.fill(' ', 63);
    line.add("\n");
    return line;
}

/// At least 16 bytes, as the maker's programs send them.
PolhemLine currentLine(const Vec3& amperes) noexcept {
    PolhemLine line;
    for (int motor = 0; motor < 3; ++motor) {
        line.add(motor == 0 ? "[" : ",");
        line.addThousandths(amperes[motor]);
    }
    line.add("]\n");
    line.fill('\0', 16);
    return line;
}

} // namespace tactum
