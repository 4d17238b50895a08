#include "core/study/design.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace tactum {

namespace {

using Fault = std::optional<std::string>;

/// A whole number or a number of a study, and what it may be.
Fault outside(const char* what, double value, double least, double most) {
    if (value >= least && value <= most) return {};
    std::string said = std::string(what) + " is ";
    appendNumber(said, value);
    appendNumber(said += "; set it inside ", least);
    appendNumber(said += " to ", most);
    return said;
}

template <class... Faults> Fault firstOf(const Faults&... faults) {
    Fault first;
    ((first = first ? first : faults), ...);
    return first;
}

Fault faultOfConditions(const StudyDesign& design) {
    const std::size_t least =
        design.procedure == Procedure::List || design.procedure == Procedure::Staircase ? 1 : 2;
    const auto& names = design.conditions;
    if (names.size() < least)
        return "conditions: there are " + std::to_string(names.size()) + " and the procedure needs " +
               std::to_string(least) + "; keep a state of the scene";
    if (names.size() > std::size_t(kMaxConditions))
        return "conditions: there are more than " + std::to_string(kMaxConditions) + "; remove some";
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (trimmed(names[i]).empty()) return "conditions: one has no name; give it one";
        if (std::find(names.begin(), names.begin() + std::ptrdiff_t(i), names[i]) !=
            names.begin() + std::ptrdiff_t(i))
            return "conditions: two are called " + inQuotes(names[i]) + "; rename one";
    }
    return {};
}

Fault faultOfLevels(const StaircaseRule& rule, const Parameter& parameter) {
    if (rule.smallest < 0 || rule.smallest > rule.largest || (rule.ratio && rule.smallest <= 0))
        return rule.ratio ? "staircase.smallest: with steps that multiply it has to be above 0 and not above "
                            "the largest level; set it"
                          : "staircase.smallest: it has to be from 0 to the largest level; set it";
    if (!parameter.allows(rule.reference) || !parameter.allows(rule.reference + rule.largest)) {
        std::string range;
        appendNumber(range, parameter.minimum);
        appendNumber(range += " to ", parameter.maximum);
        return "staircase: the reference and the largest level above it leave the range of " +
               std::string(parameter.label) + ", " + range + " " + std::string(parameter.unit) +
               "; lower them";
    }
    return outside("staircase.start", rule.start, rule.smallest, rule.largest);
}

Fault faultOfSteps(const StaircaseRule& rule) {
    if (rule.steps.empty() || rule.steps.size() > 32) return "staircase.steps: give 1 to 32 of them";
    for (const double step : rule.steps)
        if (!std::isfinite(step) || step <= (rule.ratio ? 1 : 0))
            return rule.ratio ? "staircase.steps: one that multiplies has to be above 1; raise it"
                              : "staircase.steps: one is not above 0; raise it";
    return {};
}

Fault faultOfStaircase(const StaircaseRule& rule) {
    const auto value = valueOf(rule);
    if (!value)
        return "staircase.parameter: there is none called " + inQuotes(rule.parameter) +
               "; take a key that tactum info lists, as stiffness, or layers[0].height";
    return firstOf(faultOfLevels(rule, value->parameter()), faultOfSteps(rule),
                   outside("staircase.down", rule.down, 1, 4),
                   outside("staircase.reversals", rule.reversals, 1, 1000),
                   outside("staircase.used", rule.used, 1, rule.reversals),
                   outside("staircase.trials", rule.trials, 1, kMaxTrials));
}

Fault faultOf(const StudyQuestion& question) {
    if (trimmed(question.text).empty()) return "questions: one has no text; write it or remove the question";
    if (question.kind == StudyQuestion::Kind::Rating)
        return outside("the steps of a rating", question.steps, 2, 11);
    if (question.kind != StudyQuestion::Kind::Choice) return {};
    const std::size_t count = question.choices.size();
    const bool named =
        std::ranges::none_of(question.choices, [](const std::string& one) { return trimmed(one).empty(); });
    if (count < 2 || count > 9 || !named)
        return "questions: " + inQuotes(question.text) + " needs 2 to 9 choices, each with a text; give them";
    return {};
}

Fault faultOfTexts(const StudyDesign& design) {
    std::vector<const std::string*> texts{&design.name, &design.instructions, &design.prompt,
                                          &design.staircase.surface, &design.staircase.object};
    for (const std::string& name : design.conditions)
        texts.push_back(&name);
    for (const StudyQuestion& question : design.questions) {
        texts.insert(texts.end(), {&question.text, &question.low, &question.high});
        for (const std::string& choice : question.choices)
            texts.push_back(&choice);
    }
    const bool fits =
        std::ranges::all_of(texts, [](const std::string* text) { return text->size() <= kLongestStudyText; });
    return fits ? Fault()
                : "a text is longer than " + std::to_string(kLongestStudyText) + " bytes; shorten it";
}

Fault faultOfQuestions(const StudyDesign& design) {
    if (design.questions.size() > std::size_t(kMaxQuestions))
        return "questions: there are more than " + std::to_string(kMaxQuestions) + "; remove some";
    for (const StudyQuestion& question : design.questions)
        if (const Fault fault = faultOf(question)) return fault;
    return {};
}

Fault faultOfOrder(const StudyDesign& design) {
    if (design.order == StudyOrder::Balanced && design.procedure != Procedure::List)
        return "order: balanced is for a list of conditions; choose random";
    if (trialsOf(design) > kMaxTrials)
        return "repeats: more than " + std::to_string(kMaxTrials) + " trials come of it; lower it";
    return {};
}

int pairsOf(std::size_t conditions) {
    return int(conditions * (conditions - 1) / 2);
}

} // namespace

Result<void> check(const StudyDesign& design) {
    const Fault nameless =
        trimmed(design.name).empty() ? Fault("name: the study has none; give it one") : Fault();
    const Fault fault =
        firstOf(nameless, faultOfTexts(design), faultOfConditions(design),
                outside("repeats", design.repeats, 1, kMaxRepetitions), faultOfOrder(design),
                design.procedure == Procedure::Staircase ? faultOfStaircase(design.staircase) : Fault(),
                faultOfQuestions(design), outside("stimulusSeconds", design.stimulusSeconds, 0, 3600),
                outside("pauseSeconds", design.pauseSeconds, 0, 3600),
                outside("touchEvery", design.touchEvery, 1, 1000));
    if (fault) return inputError(*fault);
    return {};
}

std::optional<SceneValue> valueOf(const StaircaseRule& rule) {
    return SceneValue::named(rule.parameter);
}

NamedPlace placeOf(const StaircaseRule& rule) {
    return {rule.object, rule.surface};
}

int intervalsOf(const StudyDesign& design) {
    switch (design.procedure) {
    case Procedure::List:
        return 1;
    case Procedure::Pairs:
        return 2;
    case Procedure::Abx:
        return 3;
    case Procedure::Staircase:
        break;
    }
    return design.staircase.compares ? 2 : 1;
}

int trialsOf(const StudyDesign& design) {
    if (design.procedure == Procedure::Staircase) return design.staircase.trials;
    const std::size_t conditions = std::min(design.conditions.size(), std::size_t(kMaxConditions));
    const int different = design.procedure == Procedure::List ? int(conditions) : pairsOf(conditions);
    return different * std::clamp(design.repeats, 0, kMaxRepetitions);
}

std::string promptOf(const StudyDesign& design) {
    if (design.procedure == Procedure::List) return {};
    if (!trimmed(design.prompt).empty()) return design.prompt;
    if (design.procedure == Procedure::Abx) return "Which of the two was X?";
    if (design.procedure == Procedure::Pairs) return "Which of the two did you prefer?";
    return design.staircase.compares ? "Which of the two was stronger?" : "Did you feel it?";
}

std::vector<std::string> choicesOf(const StudyDesign& design) {
    if (design.procedure == Procedure::List) return {};
    if (design.procedure == Procedure::Abx) return {"A", "B"};
    if (intervalsOf(design) == 2) return {"1", "2"};
    return {"Yes", "No"};
}

} // namespace tactum
