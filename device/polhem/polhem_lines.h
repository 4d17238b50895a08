// What goes over the wire of a Polhem: one line of text asks and pushes, one line answers.
//
// Its boards have spoken two ways, both published by Haptikfabriken:
//   Forces, 2020 and 2021: "X Y Z 2 0 0 0", the force in mN, as a line of 64 bytes; the answer
//     "X Y Z A L D E I" is where the finger is, in mm, four angles and whether the button for calibrating
//     was pressed. The board knows the arm, and takes the force away after 0.1 s without a line. (Micro API
//     0.1 and 0.2, forsslund/haptikfabrikenapi; polhem_teensy.ino in forsslund/polhemstylus.)
//   Currents, since 2023: "[A,B,C]", those of the motors in mA; the answer "[M,a,b,c,d,e,f,E]" is the
//     model, 1 for a Polhem, six encoders since it got power, and an error. Here the arm is ours
//     (polhem_arm.h). What the board does without a line is not published. (API 0.5, forsslund/hfabapi.)
// Frame of the maker: x toward the person, y to the right, z up.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/vec.h"

namespace tactum {

enum class PolhemSpeech : std::uint8_t { Forces, Currents };

struct PolhemCounts {
    int model = 0;
    std::array<int, 6> encoders{};
    int error = 0;
};

// Thread: real time.

struct PolhemPlace {
    Vec3 position = Vec3::Zero();   ///< m, frame D
    std::array<double, 4> angles{}; ///< rad, as polhem_arm.h turns them; they may be no numbers
};

/// nullopt where the line says something else, or a place that no arm reaches.
std::optional<PolhemPlace> placeIn(std::string_view line) noexcept;
std::optional<PolhemCounts> countsIn(std::string_view line) noexcept;
/// Numbers alone, as a board answers that speaks of places and has not been asked for one yet.
bool isOfPlaces(std::string_view line) noexcept;

/// A line to send.
class PolhemLine {
public:
    operator std::string_view() const noexcept { return {text_.data(), size_}; }

    void add(std::string_view text) noexcept;
    void addThousandths(double value) noexcept; ///< a whole number that has 16 bits; 0 for what is none
    void fill(char with, std::size_t size) noexcept;

private:
    std::array<char, 64> text_{};
    std::size_t size_ = 0;
};
PolhemLine forceLine(const Vec3& force) noexcept;     ///< N, frame D
PolhemLine currentLine(const Vec3& amperes) noexcept; ///< A, of the three motors

/// No force. They end a line that may be under way, first.
inline constexpr std::string_view kNoForce = "\n0 0 0 2 0 0 0\n", kNoCurrent = "\n[0,0,0]\n\0\0\0\0\0\0";

/// Cuts what comes into lines. What is longer than any line of a board is passed over to its end.
class PolhemReader {
public:
    /// Calls each(line) for every line that is whole now.
    template <class Each> void take(std::string_view bytes, Each each) noexcept {
        for (const char c : bytes)
            if (c == '\n') {
                if (size_ <= line_.size()) each(std::string_view(line_.data(), size_));
                size_ = 0;
            } else if (c != '\0' && c != '\r' && size_ <= line_.size()) {
                if (size_ < line_.size()) line_[size_] = c;
                ++size_;
            }
    }
    void forget() noexcept { size_ = 0; }

private:
    std::array<char, 128> line_{};
    std::size_t size_ = 0; ///< one more than there is room for: too long
};

} // namespace tactum
