// What a study asks of a participant: conditions, the procedure that orders them, and questions. Plain
// values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene_value.h"

namespace tactum {

/// The order in which trials come.
enum class StudyOrder {
    AsListed,
    Random,  ///< within each repetition, every order as likely as any other
    Balanced ///< a row of a Latin square for each participant, balanced for what comes before what
};

/// What is felt in a trial, and what is asked about it.
enum class Procedure {
    List,     ///< one condition a trial; only the questions are asked
    Pairs,    ///< two conditions a trial, each with each: the participant chooses one of them
    Abx,      ///< A, B, and X, which is one of the two: which? Each pair of conditions
    Staircase ///< one value of a parameter, followed up and down
};

/// Asked after a trial.
struct StudyQuestion {
    enum class Kind {
        Rating, ///< a whole number from 1 to `steps`
        Choice, ///< one of `choices`
        Text,
        Magnitude ///< any number above 0: a magnitude estimate
    };
    Kind kind = Kind::Rating;
    std::string text;
    std::string low, high; ///< the ends of a rating in words
    int steps = 7;         ///< of a rating: 2 to 11
    std::vector<std::string> choices;

    bool operator==(const StudyQuestion&) const = default;
};

/// A transformed up-down staircase: `down` right answers in a row make the level smaller, one wrong answer
/// makes it larger (Levitt 1971, J. Acoust. Soc. Am. 49, 467-477). The level is added to the reference and is
/// in the parameter's unit, as all values here.
struct StaircaseRule {
    std::string surface, object;              ///< names of those that change; empty: all of them
    std::string parameter = "stiffness";      ///< path of a SceneValue
    bool compares = true;                     ///< with the reference; else one interval: felt, or not?
    double reference = 400;                   ///< value at the level 0
    double start = 200;                       ///< first level
    double smallest = 0, largest = 400;       ///< levels
    std::vector<double> steps = {80, 40, 20}; ///< after 0, 1, 2 ... reversals; the last one stays
    bool ratio = false;                       ///< steps multiply and divide the level
    int down = 2;                             ///< 1 to 4
    int reversals = 10;                       ///< it ends after them
    int used = 8;                             ///< the threshold is the mean of the last of them
    int trials = 100;                         ///< it ends after them at the latest

    bool operator==(const StaircaseRule&) const = default;
};

/// What the participant sees of the scene.
enum class StudyView { Shown, Frozen, Hidden };

struct StudyDesign {
    std::string name;
    std::string instructions;            ///< on the first page
    std::vector<std::string> conditions; ///< names, which the participant never sees
    Procedure procedure = Procedure::List;
    StudyOrder order = StudyOrder::Random;
    int repeats = 1;        ///< of each condition or pair
    std::uint64_t seed = 0; ///< of what is random; 0: another one for each run
    std::string prompt;     ///< the question of Pairs, Abx and Staircase; empty: promptOf() has one
    StaircaseRule staircase;
    std::vector<StudyQuestion> questions;
    double stimulusSeconds = 0; ///< after which an interval ends by itself; 0: when the participant says so
    double pauseSeconds = 0;    ///< after each trial
    bool again = true;          ///< intervals may be felt again before the choice
    bool forcesOffBetween = false;
    StudyView view = StudyView::Shown;
    int touchEvery = 1; ///< the log of the touch has every so many-th servo tick

    bool operator==(const StudyDesign&) const = default;
};

/// Most of everything: a file beyond is refused.
inline constexpr int kMaxConditions = 64, kMaxRepetitions = 1000, kMaxTrials = 10000, kMaxQuestions = 32;
inline constexpr std::size_t kLongestStudyText = 4000; ///< bytes

/// Whether the study can be run. Errors: one sentence with the member at fault and the remedy. Thread: any.
Result<void> check(const StudyDesign& design);

/// What a staircase bends; nothing where no table has its parameter.
std::optional<SceneValue> valueOf(const StaircaseRule& rule);
/// Where it does.
NamedPlace placeOf(const StaircaseRule& rule);

/// How many intervals a trial has, 1 to 3.
int intervalsOf(const StudyDesign& design);
/// The trials of a run; of a staircase the most that there can be.
int trialsOf(const StudyDesign& design);
/// What is asked after the intervals of a trial; empty for a list.
std::string promptOf(const StudyDesign& design);
/// What may be answered to it, in the order of StudyTrial::right; empty for a list.
std::vector<std::string> choicesOf(const StudyDesign& design);

/// The names of enumerators in files and logs, in their order.
inline constexpr const char* kProcedureNames[] = {"list", "pairs", "abx", "staircase"};
inline constexpr const char* kOrderNames[] = {"listed", "random", "balanced"};
inline constexpr const char* kViewNames[] = {"shown", "frozen", "hidden"};
inline constexpr const char* kQuestionNames[] = {"rating", "choice", "text", "magnitude"};

} // namespace tactum
