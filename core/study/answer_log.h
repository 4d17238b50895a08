// The answers of a run as CSV: a line of names with their units, then a row for each trial.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/study_run.h"

namespace tactum {

/// What a trial is logged with besides itself.
struct TrialFacts {
    std::string scene;         ///< fingerprintOf() the study's file
    std::string time;          ///< when it was answered, ISO 8601, UTC
    double clock = 0;          ///< ms, of a clock that nobody sets, when it was answered
    std::vector<double> begun; ///< s of the log of the touch: when each interval began first
    double answered = 0;       ///< s of the same
    int felt = 0;              ///< intervals that were felt, those that were felt again too
    double reaction = 0;       ///< ms, from the end of the last interval to the choice or the first reply
    std::string device;
    double ceiling = 0;       ///< N/m: the stiffness up to which surfaces were rendered, at the end
    std::uint64_t faults = 0; ///< in this trial
};

/// The columns; the last ones are q1, q2 ... for the questions.
std::string answerHeader(const StudyDesign& design);
/// Of the newest trial of the run, which has one. Numbers have a decimal point and as many digits as read
/// back to the same number; what a procedure has not is empty.
std::string answerRow(const StudyRun& run, const TrialFacts& facts);

/// What a log says of its run, for going on.
struct LoggedRun {
    int participant = 0;
    std::uint64_t seed = 0;
    std::string scene;
    std::vector<TrialAnswer> answers;
    std::size_t bytes = 0; ///< of whole rows: what comes after them a crash has left unfinished
};

/// Errors: one sentence with the line: no log of this study or of these columns, or one that somebody has
/// edited. Thread: any.
Result<LoggedRun> readAnswers(std::string_view csv, const StudyDesign& design);

} // namespace tactum
