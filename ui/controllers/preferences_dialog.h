// The dialog of what a person decides for the whole program.
#pragma once

class QWidget;

namespace tactum {

/// Opens it beside what goes on, or brings it to the front. What is set counts at once. Thread: ui.
void showPreferences(QWidget* parent);

} // namespace tactum
