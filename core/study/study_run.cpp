#include "core/study/study_run.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace tactum {

Result<std::string> answerTo(const StudyQuestion& question, std::string_view words) {
    const std::string_view said = trimmed(words);
    std::int64_t whole = 0;
    const std::optional<double> number = parseNumber(said);
    switch (question.kind) {
    case StudyQuestion::Kind::Rating:
        if (parseNumber(said, whole) && whole >= 1 && whole <= question.steps) return std::to_string(whole);
        return inputError("A rating is a whole number from 1 to " + std::to_string(question.steps) +
                          "; choose one.");
    case StudyQuestion::Kind::Choice:
        if (std::ranges::find(question.choices, said) != question.choices.end()) return std::string(said);
        return inputError(inQuotes(said) + " is none of the choices; choose one.");
    case StudyQuestion::Kind::Magnitude:
        if (number && *number > 0) return std::string(said);
        return inputError("A magnitude is a number above 0; type one.");
    case StudyQuestion::Kind::Text:
        break;
    }
    return printable(said, kLongestStudyText); // one line of the log
}

Result<StudyRun> StudyRun::begin(const StudyDesign& design, int participant, std::uint64_t seed) {
    if (const auto sound = check(design); !sound) return tl::unexpected<Error>(sound.error());
    if (participant < 1) return inputError("participants are numbered from 1; give a number");
    return StudyRun(design, participant, seed);
}

Result<StudyRun> StudyRun::resume(const StudyDesign& design, int participant, std::uint64_t seed,
                                  std::span<const TrialAnswer> answers) {
    auto run = begin(design, participant, seed);
    if (!run) return run;
    for (const TrialAnswer& answer : answers)
        if (const auto taken = run->take(answer); !taken)
            return inputError("trial " + std::to_string(run->number()) +
                              " was answered otherwise than this study asks; begin a new run (" +
                              taken.error().text + ")");
    if (run->step_ != StudyStep::Done) run->step_ = StudyStep::Instructions;
    return run;
}

StudyRun::StudyRun(const StudyDesign& design, int participant, std::uint64_t seed)
    : design_(std::make_shared<const StudyDesign>(design)), participant_(participant), seed_(seed),
      random_(seed, participant), staircase_(design.staircase) {
    if (design.procedure != Procedure::Staircase) planned_ = trialsFor(design, participant, seed);
    prepare();
}

/// The trial that is due now.
void StudyRun::prepare() {
    interval_ = question_ = 0;
    answer_ = {};
    if (design_->procedure != Procedure::Staircase) {
        trial_ = planned_[done_.size()];
        return;
    }
    const StaircaseRule& rule = design_->staircase;
    trial_ = {};
    trial_.level = staircase_.level();
    const Stimulus stronger{0, rule.reference + trial_.level};
    trial_.right = rule.compares ? random_.below(2) : 0;
    trial_.intervals = {stronger};
    if (rule.compares)
        trial_.intervals.insert(trial_.intervals.begin() + (1 - *trial_.right), Stimulus{0, rule.reference});
}

void StudyRun::proceed() {
    if (step_ == StudyStep::Instructions || step_ == StudyStep::Pause) {
        step_ = StudyStep::Stimulus;
    } else if (step_ == StudyStep::Stimulus && interval_ + 1 < int(trial_.intervals.size())) {
        ++interval_;
    } else if (step_ == StudyStep::Stimulus) {
        if (design_->procedure == Procedure::List)
            askNext();
        else
            step_ = StudyStep::Choice;
    }
}

bool StudyRun::feelAgain(int interval) {
    const bool chooses = step_ == StudyStep::Choice;
    if (!design_->again || !chooses || interval < 0 || interval >= int(trial_.intervals.size())) return false;
    interval_ = interval;
    step_ = StudyStep::Stimulus;
    return true;
}

Result<void> StudyRun::choose(int chosen) {
    if (step_ != StudyStep::Choice) return inputError("Nothing is to be chosen now; feel the stimuli first.");
    if (chosen < 0 || chosen >= int(choicesOf(*design_).size()))
        return inputError("There is no such choice; choose another.");
    answer_.chosen = chosen;
    askNext();
    return {};
}

Result<void> StudyRun::reply(std::string_view words) {
    if (step_ != StudyStep::Question) return inputError("Nothing is asked now; feel the stimuli first.");
    auto answer = answerTo(design_->questions[std::size_t(question_)], words);
    if (!answer) return tl::unexpected<Error>(answer.error());
    answer_.answers.push_back(std::move(*answer));
    askNext();
    return {};
}

void StudyRun::askNext() {
    question_ = int(answer_.answers.size());
    if (question_ < int(design_->questions.size()))
        step_ = StudyStep::Question;
    else
        finish();
}

void StudyRun::finish() {
    DoneTrial done{trial_, answer_, {}, false};
    if (trial_.right) done.correct = answer_.chosen == trial_.right;
    bool over = done_.size() + 1 >= planned_.size();
    if (design_->procedure == Procedure::Staircase) {
        done.reversal = staircase_.answer(*done.correct);
        over = staircase_.done();
    }
    done_.push_back(std::move(done));
    step_ = over ? StudyStep::Done : design_->pauseSeconds > 0 ? StudyStep::Pause : StudyStep::Stimulus;
    if (!over) prepare();
}

Result<void> StudyRun::take(const TrialAnswer& answer) {
    if (step_ == StudyStep::Done) return inputError("the study was over already");
    const std::size_t before = done_.size();
    while (step_ != StudyStep::Choice && step_ != StudyStep::Question && done_.size() == before)
        proceed();
    if (answer.chosen.has_value() != (step_ == StudyStep::Choice))
        return inputError("a choice is missing, or too many");
    if (answer.chosen)
        if (const auto chosen = choose(*answer.chosen); !chosen) return chosen;
    for (const std::string& words : answer.answers)
        if (const auto replied = reply(words); !replied) return replied;
    return done_.size() == before ? inputError("an answer is missing") : Result<void>{};
}

} // namespace tactum
