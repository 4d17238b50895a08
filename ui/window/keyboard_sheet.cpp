#include "ui/window/keyboard_sheet.h"

#include <algorithm>

#include <QDialog>
#include <QGridLayout>
#include <QKeySequence>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/base/shortcuts.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

QString nativeKeys(const char* portable) {
    QStringList names;
    for (const QString& part : QString::fromLatin1(portable).split(QStringLiteral("; "), Qt::SkipEmptyParts))
        names << QKeySequence::fromString(part).toString(QKeySequence::NativeText);
    return names.join(QStringLiteral(", "));
}

void addKeyRow(QGridLayout& grid, const QString& keys, const QString& meaning) {
    const int row = grid.rowCount();
    auto* left = new QLabel(keys);
    left->setProperty("heading", true);
    grid.addWidget(left, row, 0);
    grid.addWidget(new QLabel(meaning), row, 1);
}

void addHeading(QGridLayout& grid, const QString& text) {
    auto* heading = new QLabel(text);
    heading->setProperty("dimmed", true);
    grid.addWidget(heading, grid.rowCount(), 0, 1, 2);
}

/// A row of a Markdown table; keys stand as they are printed on the keyboard.
QString pageRow(const QStringList& keys, const QString& meaning) {
    return QStringLiteral("| %1 | %2 |\n").arg(keys.join(QStringLiteral(", ")), meaning);
}

QStringList quotedKeys(const char* portable) {
    QStringList keys;
    for (const QString& key : QString::fromLatin1(portable).split(QStringLiteral("; "), Qt::SkipEmptyParts))
        keys << u'`' + key + u'`';
    return keys;
}

} // namespace

QString keyboardPage() {
    QString page = QStringLiteral(
        "# Keyboard and mouse\n\nMade from the program's own table of commands (`ui/base/shortcuts.cpp`); a "
        "test "
        "holds the two together. In the program\n`F1` shows the same. Every command, also those without a "
        "key, is found by a few letters of it with `Ctrl+Shift+P`.\n");
    QString menu;
    for (const Command& command : commands()) {
        if (!*command.keys) continue;
        const QString title = QString::fromLatin1(command.menu).section(u'/', 0, 0);
        if (title != menu) page += QStringLiteral("\n## %1\n| keys | do |\n|---|---|\n").arg(title);
        menu = title;
        page += pageRow(quotedKeys(command.keys), QString::fromLatin1(command.sentence));
    }
    page += QStringLiteral("\n## In the view\n| what you do | does |\n|---|---|\n");
    for (const Manner& manner : viewManners())
        page += pageRow({QString::fromLatin1(manner.keys)}, QString::fromLatin1(manner.text));
    return page;
}

void showKeyboardSheet(QWidget* parent) {
    auto* sheet = new QDialog(parent);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->setWindowTitle(QObject::tr("Keyboard and mouse"));
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(3 * kRhythm, 2 * kRhythm, 3 * kRhythm, 3 * kRhythm);
    grid->setHorizontalSpacing(3 * kRhythm);
    grid->setVerticalSpacing(kRhythm / 2);
    addHeading(*grid, QObject::tr("Anywhere"));
    for (const Command& command : commands())
        if (*command.keys) addKeyRow(*grid, nativeKeys(command.keys), QObject::tr(command.sentence));
    addHeading(*grid, QObject::tr("In the view"));
    for (const Manner& manner : viewManners())
        addKeyRow(*grid, QObject::tr(manner.keys), QObject::tr(manner.text));
    auto* scroll = new QScrollArea;
    scroll->setAccessibleName(sheet->windowTitle());
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QVBoxLayout(sheet);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scroll);
    const QSize room = parent->screen()->availableSize();
    const int wide = page->sizeHint().width() + scroll->verticalScrollBar()->sizeHint().width();
    sheet->resize(std::min(wide, room.width()),
                  std::min(page->sizeHint().height(), std::min(parent->height(), room.height())));
    sheet->show();
}

} // namespace tactum
