// A person at the window, who has a mouse and a keyboard and nothing else: whatever happens comes by their
// events.
#pragma once

#include <QString>

#include "tests/ui/window/window_fixture.h"

class QTreeWidget;
class QTreeWidgetItem;

namespace tactum::test {

class Person {
public:
    explicit Person(TouchedWindow& program) : program_(program) {}

    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {});
    void write(const QString& text);
    /// Into the middle of something that is seen.
    void click(QWidget& on, Qt::KeyboardModifiers modifiers = {});
    void click(QWidget& on, QPoint at, Qt::KeyboardModifiers modifiers = {});
    /// A row, with the wheel before where it is not seen.
    void click(QTreeWidget& list, QTreeWidgetItem* row, Qt::KeyboardModifiers modifiers = {});
    /// In the view.
    void clickView(QPoint at) { click(viewOf(), at); }
    void drag(QPoint from, QPoint to);
    /// A command by its menus, clicked at: "File", "Add", "Models...", without the signs of mnemonics.
    void menu(const QStringList& way);
    /// Ctrl+Shift+P, some letters, Enter. `offered`: what has to be the first of the list then.
    void palette(const QString& letters, const QString& offered);
    /// Into a field of numbers, over what was in it.
    void number(const char* field, const QString& value);
    /// Types a name into the next dialog that asks for files, and Enter.
    static void answerFiles(const QString& name);

private:
    QWindow& windowOf() const;
    QWidget& viewOf() const;

    TouchedWindow& program_;
};

} // namespace tactum::test
