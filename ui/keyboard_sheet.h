// Help > Keyboard: all keys on one page, made from the table of commands.
#pragma once

class QWidget;

namespace tactum {

/// Opens the sheet; it closes with Esc.
void showKeyboardSheet(QWidget* parent);

} // namespace tactum
