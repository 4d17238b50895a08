// Help > Keyboard: all keys on one page, made from the table of commands.
#pragma once

#include <QString>

class QWidget;

namespace tactum {

/// Opens the sheet; it closes with Esc.
void showKeyboardSheet(QWidget* parent);
/// The same as the page of the guide, in Markdown.
QString keyboardPage();

} // namespace tactum
