// In which order what is felt comes: listed, random or balanced. Pure, the same on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "core/study/design.h"

namespace tactum {

/// One interval of a trial.
struct Stimulus {
    int condition = 0;           ///< of StudyDesign::conditions
    std::optional<double> value; ///< of a staircase's parameter, in its unit

    bool operator==(const Stimulus&) const = default;
};

struct StudyTrial {
    std::vector<Stimulus> intervals; ///< in the order in which they are felt
    std::optional<int> right; ///< of choicesOf(): the answer that is correct; none: there is no such thing
    double level = 0;         ///< of a staircase

    bool operator==(const StudyTrial&) const = default;
};

/// Numbers that follow from a seed and a participant alone: the same with every compiler.
class StudyRandom {
public:
    StudyRandom(std::uint64_t seed, int participant);
    /// 0 to `count` - 1, each as likely; `count` at least 1.
    int below(int count);
    template <class T> void shuffle(std::span<T> values) {
        for (std::size_t i = values.size(); i > 1; --i)
            std::swap(values[i - 1], values[std::size_t(below(int(i)))]);
    }

private:
    std::mt19937_64 engine_;
};

/// Row `row` of a Latin square of `count` places that is balanced: over its rows (`count` of them, twice as
/// many where it is odd, after which they begin anew) each stands once, or twice, in each place and follows
/// each other equally often (Williams 1949, Aust. J. Sci. Res. A 2, 149-168).
std::vector<int> latinRow(int count, int row);

/// The trials of a design that is no staircase, which check() allows. `participant` from 1.
std::vector<StudyTrial> trialsFor(const StudyDesign& design, int participant, std::uint64_t seed);

} // namespace tactum
