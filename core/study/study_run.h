// One run of a study with one participant: what comes next, and what was answered. Without a clock, a window
// or a device, so that a test, a script and the window run the same.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/staircase.h"
#include "core/study/trial_order.h"

namespace tactum {

/// What the participant said after a trial.
struct TrialAnswer {
    std::optional<int> chosen;        ///< of choicesOf(); none where nothing is to be chosen
    std::vector<std::string> answers; ///< one for each of StudyDesign::questions

    bool operator==(const TrialAnswer&) const = default;
};

struct DoneTrial {
    StudyTrial trial;
    TrialAnswer answer;
    std::optional<bool> correct; ///< none where no answer is the right one
    bool reversal = false;       ///< of a staircase
};

/// What goes on. A trial is its stimuli, the choice, its questions, and a pause before the next one.
enum class StudyStep { Instructions, Stimulus, Choice, Question, Pause, Done };

/// Answers are refused in one sentence, and nothing has changed then. Thread: any, one at a time.
class StudyRun {
public:
    /// `participant` from 1. Errors: what check() says.
    static Result<StudyRun> begin(const StudyDesign& design, int participant, std::uint64_t seed);
    /// The same after the trials with these answers: a run that broke off goes on, with the instructions
    /// first. Errors: an answer that cannot have been given in it.
    static Result<StudyRun> resume(const StudyDesign& design, int participant, std::uint64_t seed,
                                   std::span<const TrialAnswer> answers);

    const StudyDesign& design() const { return *design_; }
    int participant() const { return participant_; }
    std::uint64_t seed() const { return seed_; }

    StudyStep step() const { return step_; }
    /// The trial that is under way, from 1; at the end one more than there were.
    int number() const { return int(done_.size()) + 1; }
    const StudyTrial& trial() const { return trial_; }
    int interval() const { return interval_; } ///< from 0
    int question() const { return question_; } ///< from 0

    /// Ends the instructions, an interval or a pause; does nothing at another step.
    void proceed();
    /// Back to an interval of this trial before the choice is made. False where that may not be.
    bool feelAgain(int interval);
    /// At the choice. Errors: there is no such choice.
    Result<void> choose(int chosen);
    /// At a question. Errors: what is no answer to it.
    Result<void> reply(std::string_view words);

    /// The trials so far, the newest last.
    const std::vector<DoneTrial>& done() const { return done_; }
    /// Of a staircase, so far.
    std::optional<Threshold> threshold() const { return staircase_.threshold(); }

private:
    StudyRun(const StudyDesign& design, int participant, std::uint64_t seed);
    void prepare();
    void askNext();
    void finish();
    Result<void> take(const TrialAnswer& answer);

    std::shared_ptr<const StudyDesign> design_;
    int participant_;
    std::uint64_t seed_;
    std::vector<StudyTrial> planned_; ///< of what is no staircase
    StudyRandom random_;              ///< which interval of a staircase is the reference
    Staircase staircase_;
    StudyStep step_ = StudyStep::Instructions;
    StudyTrial trial_;
    int interval_ = 0, question_ = 0;
    TrialAnswer answer_;
    std::vector<DoneTrial> done_;
};

/// An answer as it is logged, when it is one to the question. Errors: what is expected instead.
Result<std::string> answerTo(const StudyQuestion& question, std::string_view words);

} // namespace tactum
