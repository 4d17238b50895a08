#include "tests/ui/window/person.h"

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <QWheelEvent>
#include <QWindow>

#include "ui/view/scene_view.h"
#include "ui/widgets/command_palette.h"

namespace tactum::test {

namespace {

void writeInto(QWindow& window, const QString& text) {
    for (const char letter : text.toLatin1())
        QTest::keyClick(&window, letter);
}

void clickAt(QWidget& window, const QWidget& on, QPoint at, Qt::KeyboardModifiers modifiers) {
    if (!on.visibleRegion().contains(at)) qFatal("nobody sees %s", qPrintable(on.objectName()));
    const QPoint there = on.mapTo(&window, at);
    QTest::mouseMove(window.windowHandle(), there);
    QTest::mouseClick(window.windowHandle(), Qt::LeftButton, modifiers, there);
}

/// A notch, away from the person where it is positive: what is above comes down.
void turnWheel(QWidget& over, int notch) {
    const QPoint at = over.rect().center();
    QWheelEvent event(at, over.mapToGlobal(at), {}, {0, 120 * notch}, {}, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&over, &event);
}

QAction* named(const QList<QAction*>& actions, const QString& text) {
    for (QAction* action : actions)
        if (action->text().remove(u'&') == text && action->isEnabled()) return action;
    qFatal("there is no %s to be chosen", qPrintable(text));
    Q_UNREACHABLE();
}

} // namespace

/// Which has the keyboard again when a dialog or a menu has gone: a window manager would see to that.
QWindow& Person::windowOf() const {
    if (!program_.window->isActiveWindow()) QApplication::setActiveWindow(program_.window.get());
    return *program_.window->windowHandle();
}

QWidget& Person::viewOf() const {
    return program_.window->view();
}

void Person::key(Qt::Key which, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(&windowOf(), which, modifiers);
}

void Person::write(const QString& text) {
    writeInto(windowOf(), text);
}

void Person::click(QWidget& on, Qt::KeyboardModifiers modifiers) {
    click(on, on.rect().center(), modifiers);
}

void Person::click(QWidget& on, QPoint at, Qt::KeyboardModifiers modifiers) {
    clickAt(*program_.window, on, at, modifiers);
}

void Person::click(QTreeWidget& list, QTreeWidgetItem* row, Qt::KeyboardModifiers modifiers) {
    if (!row) qFatal("a row is not there");
    const auto at = [&] { return list.visualItemRect(row).center(); };
    QWidget& page = *list.viewport();
    for (int i = 0; i < 50 && !page.rect().contains(at()); ++i)
        turnWheel(page, at().y() < 0 ? 1 : -1);
    click(page, at(), modifiers);
}

void Person::drag(QPoint from, QPoint to) {
    program_.moveTo(from);
    program_.press(from);
    for (int i = 1; i <= 5; ++i)
        program_.moveTo(from + (to - from) * i / 5);
    program_.release(to);
}

void Person::menu(const QStringList& way) {
    QMenuBar& bar = *program_.window->menuBar();
    QAction* action = named(bar.actions(), way.front());
    click(bar, bar.actionGeometry(action).center());
    for (const QString& text : way.mid(1)) {
        QMenu* menu = action->menu();
        if (!menu || !waitFor([&] { return menu->isVisible(); })) qFatal("the menu does not open");
        action = named(menu->actions(), text);
        clickAt(*menu, *menu, menu->actionGeometry(action).center(), {});
    }
}

void Person::palette(const QString& letters, const QString& offered) {
    key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    const auto opened = [this] { return program_.window->findChild<CommandPalette*>(); };
    if (!waitFor([&] { return opened() && opened()->isVisible(); })) qFatal("the palette does not open");
    write(letters);
    const auto* first = opened()->findChild<QTreeWidget*>(QStringLiteral("palette-list"))->topLevelItem(0);
    if (!first || first->text(0) != offered)
        qFatal("the palette offers %s", first ? qPrintable(first->text(0)) : "nothing");
    key(Qt::Key_Return);
    if (!waitFor([&] { return !opened(); })) qFatal("the palette stays");
}

void Person::number(const char* field, const QString& value) {
    QDoubleSpinBox& box = program_.box(QString::fromUtf8(field));
    if (!waitFor([&] { return !box.visibleRegion().isEmpty(); })) qFatal("nobody sees %s", field);
    program_.frames(2); // its panel comes to its place
    click(box);
    key(Qt::Key_A, Qt::ControlModifier);
    write(value);
    key(Qt::Key_Return);
}

void Person::answerFiles(const QString& name) {
    auto* timer = new QTimer;
    QObject::connect(timer, &QTimer::timeout, timer, [timer, name] {
        const QPointer<QFileDialog> dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog || !dialog->isVisible()) return;
        timer->stop();
        timer->deleteLater();
        QWindow& window = *dialog->windowHandle();
        const auto* line = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        clickAt(*dialog, *line, line->rect().center(), {});
        QTest::keyClick(&window, Qt::Key_A, Qt::ControlModifier);
        writeInto(window, name);
        if (line->text() != name) qFatal("%s is in the dialog", qPrintable(line->text()));
        // The first one may close the list of names that it offers.
        for (int i = 0; i < 2 && dialog && dialog->isVisible(); ++i)
            QTest::keyClick(&window, Qt::Key_Return);
        if (dialog && dialog->isVisible()) qFatal("%s is not taken", qPrintable(name));
    });
    timer->start(20);
}

} // namespace tactum::test
