// What is asked for a study: its procedure and questions, and with whom it is run.
#pragma once

#include <optional>

#include "ui/study/study_session.h"

class QWidget;

namespace tactum {

/// The design as the author wants it; nothing where they thought better of it. `conditions`: of
/// the study, the first of which a staircase bends. Thread: ui.
std::optional<StudyDesign> askForDesign(QWidget* parent, const StudyDesign& now,
                                        const std::vector<Scene>& conditions);

/// With whom; nothing where the person thought better of it. `file`: of the study, as it is saved.
std::optional<StudyStart> askForStart(QWidget* parent, const StudyDesign& design, const QString& file);

} // namespace tactum
