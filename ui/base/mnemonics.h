// Letters for Alt: what a person can press in a dialog or a menu has one of its own.
#pragma once

#include <QString>

class QMenu;
class QWidget;

namespace tactum {

/// The text with its letter for Alt, which is not among `used` and is there afterwards: the one that the text
/// marks already if it is free, else the first free one. As it is where none is left.
QString withMnemonic(const QString& text, QString& used);

/// To all buttons of a dialog and to the labels of its fields, those that the texts mark first. Thread: ui.
void giveMnemonics(QWidget& dialog);
/// To all entries of a menu. Thread: ui.
void giveMnemonics(QMenu& menu);

/// From now on to every dialog of the program as it appears, those of Qt too. Once is enough. Thread: ui.
void giveMnemonicsToDialogs();

} // namespace tactum
