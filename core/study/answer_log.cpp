#include "core/study/answer_log.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/study/log_row.h"

namespace tactum {

namespace {

constexpr std::string_view kColumns = "format,study,scene,participant,seed,procedure,parameter,unit,trial,"
                                      "time_utc,clock_ms,condition_1,condition_2,"
                                      "condition_3,value_1,value_2,begun_1_s,begun_2_s,begun_3_s,felt,level,"
                                      "reversal,answer,chosen,correct,reaction_ms,"
                                      "answered_s,device,ceiling_N_per_m,faults";

void addStimuli(LogRow& row, const StudyRun& run, const StudyTrial& trial, const TrialFacts& facts) {
    const auto& intervals = trial.intervals;
    for (std::size_t i = 0; i < 3; ++i)
        row.text(i < intervals.size() ? run.design().conditions[std::size_t(intervals[i].condition)] : "");
    for (std::size_t i = 0; i < 2; ++i)
        row.maybe(i < intervals.size() && intervals[i].value,
                  i < intervals.size() ? intervals[i].value.value_or(0) : 0);
    for (std::size_t i = 0; i < 3; ++i)
        row.maybe(i < facts.begun.size(), i < facts.begun.size() ? facts.begun[i] : 0);
    row.number(facts.felt);
}

/// The condition that was chosen, where a choice is one.
std::string chosenOf(const StudyRun& run, const DoneTrial& done) {
    const int chosen = done.answer.chosen.value_or(-1);
    if (chosen < 0 || intervalsOf(run.design()) < 2) return {};
    return run.design().conditions[std::size_t(done.trial.intervals[std::size_t(chosen)].condition)];
}

/// Takes a field off the front of a line of CSV; false when its quotes do not end.
bool takeField(std::string_view& rest, std::string& field) {
    field.clear();
    if (!rest.starts_with('"')) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        field = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        return true;
    }
    for (std::size_t i = 1; i < rest.size(); ++i) {
        if (rest[i] != '"') {
            field += rest[i];
        } else if (i + 1 < rest.size() && rest[i + 1] == '"') {
            field += rest[i++];
        } else {
            rest.remove_prefix(std::min(i + 2, rest.size()));
            return true;
        }
    }
    return false;
}

std::optional<std::vector<std::string>> fieldsOf(std::string_view line) {
    std::vector<std::string> fields;
    const bool emptyLast = line.ends_with(',');
    for (std::string field; !line.empty(); fields.push_back(field))
        if (!takeField(line, field)) return {};
    if (emptyLast) fields.emplace_back();
    return fields;
}

/// A log that is read: its rows by the names of their columns.
class LogReader {
public:
    LogReader(std::string_view csv, const StudyDesign& design) : design_(design) {
        log_.bytes = csv.rfind('\n') + 1; // npos + 1 is 0
        csv_ = csv.substr(0, log_.bytes);
    }

    Result<LoggedRun> read() {
        Lines lines(csv_);
        std::string_view line;
        std::string header = answerHeader(design_);
        header.pop_back();
        if (!lines.next(line) || line != header)
            return inputError(
                "line 1: it is no log of this study, or of another version of it; begin a new run");
        names_ = *fieldsOf(header);
        while (lines.next(line)) {
            const auto fields = fieldsOf(line);
            if (!fields || fields->size() != names_.size() || !take(*fields))
                return inputError("line " + std::to_string(lines.number()) +
                                  ": it is no row that this study wrote; begin a new run");
        }
        return log_;
    }

private:
    const std::string& field(const std::vector<std::string>& fields, std::string_view name) const {
        return fields[std::size_t(std::ranges::find(names_, name) - names_.begin())];
    }

    bool take(const std::vector<std::string>& fields) {
        std::int64_t trial = 0, participant = 0;
        const auto seed = wholeOf(field(fields, "seed"));
        if (!parseNumber(field(fields, "trial"), trial) || std::size_t(trial) != log_.answers.size() + 1 ||
            !parseNumber(field(fields, "participant"), participant) || participant < 1 ||
            participant > 1'000'000 || !seed || field(fields, "format") != kStudyLogVersion ||
            field(fields, "study") != printable(design_.name, kLongestStudyText))
            return false;
        const bool first = log_.answers.empty();
        if (!first && (participant != log_.participant || *seed != log_.seed)) return false;
        log_.participant = int(participant);
        log_.seed = *seed;
        log_.scene = field(fields, "scene");
        return takeAnswer(fields);
    }

    static std::optional<std::uint64_t> wholeOf(const std::string& text) {
        std::uint64_t value = 0;
        for (const char c : text) {
            if (c < '0' || c > '9' || value > (UINT64_MAX - std::uint64_t(c - '0')) / 10) return {};
            value = 10 * value + std::uint64_t(c - '0');
        }
        return text.empty() ? std::nullopt : std::optional(value);
    }

    bool takeAnswer(const std::vector<std::string>& fields) {
        TrialAnswer answer;
        const auto choices = choicesOf(design_);
        const auto chosen = std::ranges::find(choices, field(fields, "answer"));
        if (!choices.empty() && chosen == choices.end()) return false;
        if (!choices.empty()) answer.chosen = int(chosen - choices.begin());
        for (std::size_t i = 0; i < design_.questions.size(); ++i)
            answer.answers.push_back(field(fields, "q" + std::to_string(i + 1)));
        log_.answers.push_back(std::move(answer));
        return true;
    }

    const StudyDesign& design_;
    std::string_view csv_;
    std::vector<std::string> names_;
    LoggedRun log_;
};

} // namespace

std::string answerHeader(const StudyDesign& design) {
    std::string header(kColumns);
    for (std::size_t i = 0; i < design.questions.size(); ++i)
        header += ",q" + std::to_string(i + 1);
    return header + '\n';
}

std::string answerRow(const StudyRun& run, const TrialFacts& facts) {
    const StudyDesign& design = run.design();
    const DoneTrial& done = run.done().back();
    const bool climbs = design.procedure == Procedure::Staircase;
    const auto bent = climbs ? valueOf(design.staircase) : std::nullopt;
    const std::vector<std::string> choices = choicesOf(design);
    LogRow row;
    row.text(kStudyLogVersion).text(printable(design.name, kLongestStudyText)).text(facts.scene);
    row.number(run.participant()).whole(run.seed()).text(kProcedureNames[int(design.procedure)]);
    row.text(bent ? bent->path() : "").text(bent ? bent->parameter().unit : "");
    row.number(double(run.done().size())).text(facts.time).number(facts.clock);
    addStimuli(row, run, done.trial, facts);
    row.maybe(climbs, done.trial.level).maybe(climbs, done.reversal);
    row.text(done.answer.chosen ? choices[std::size_t(*done.answer.chosen)] : "").text(chosenOf(run, done));
    row.maybe(done.correct.has_value(), done.correct.value_or(false))
        .number(facts.reaction)
        .number(facts.answered);
    row.text(facts.device).number(facts.ceiling).whole(facts.faults);
    for (const std::string& answer : done.answer.answers)
        row.text(answer);
    return row.line();
}

Result<LoggedRun> readAnswers(std::string_view csv, const StudyDesign& design) {
    return LogReader(csv, design).read();
}

} // namespace tactum
