// What the menus of things that are kept with the scene under names have in common. Thread: ui.
#pragma once

#include <functional>

#include <QString>
#include <QStringList>

class QMenu;
class QWidget;

namespace tactum {

/// What a person called something, in a menu: cut off where it is long.
QString inMenu(const QString& name);
/// A menu with all the names inside another one; off where there are none.
void addNamesMenu(QMenu& menu, const QString& verb, const char* id, const QStringList& names, bool possible,
                  const std::function<void(const QString&)>& does);
/// "View 3": the first number that no name has; `pattern` has its place as %1.
QString nextName(const QString& pattern, const QStringList& taken);
/// Asks for one that can be shown anywhere. Empty when the person thinks better of it. `whyNot`: a sentence
/// where that name cannot be, which is said beside what was typed; empty: it can.
QString askForName(QWidget* parent, const QString& title, const QString& label, const QString& now,
                   const std::function<QString(const QString&)>& whyNot);

} // namespace tactum
