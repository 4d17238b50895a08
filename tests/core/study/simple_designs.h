// Small designs that check() allows, for the tests of a study.
#pragma once

#include "core/study/design.h"

namespace tactum::test {

inline StudyDesign designOf(Procedure procedure, std::vector<std::string> conditions, int repeats = 1) {
    StudyDesign design;
    design.name = "Trial";
    design.procedure = procedure;
    design.conditions = std::move(conditions);
    design.repeats = repeats;
    return design;
}

/// Levels from 0 to 40 N/m above 400, one by one.
inline StudyDesign staircaseOf(int down) {
    StudyDesign design = designOf(Procedure::Staircase, {"plate"});
    StaircaseRule& rule = design.staircase;
    rule.reference = 400;
    rule.start = 26;
    rule.largest = 40;
    rule.steps = {2, 1, 0.5, 0.25};
    rule.down = down;
    rule.reversals = 44;
    rule.used = 40;
    rule.trials = 2000;
    return design;
}

} // namespace tactum::test
