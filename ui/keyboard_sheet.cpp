#include "ui/keyboard_sheet.h"

#include <QDialog>
#include <QGridLayout>
#include <QKeySequence>
#include <QLabel>

#include "ui/shortcuts.h"
#include "ui/style.h"

namespace tactum {

namespace {

QString nativeKeys(const char* portable) {
    QStringList names;
    for (const QString& part : QString::fromLatin1(portable).split(QStringLiteral("; "), Qt::SkipEmptyParts))
        names << QKeySequence::fromString(part).toString(QKeySequence::NativeText);
    return names.join(QStringLiteral(", "));
}

void addRow(QGridLayout& grid, const QString& keys, const QString& meaning) {
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

} // namespace

void showKeyboardSheet(QWidget* parent) {
    auto* sheet = new QDialog(parent);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->setWindowTitle(QObject::tr("Keyboard and mouse"));
    auto* grid = new QGridLayout(sheet);
    grid->setContentsMargins(3 * kRhythm, 2 * kRhythm, 3 * kRhythm, 3 * kRhythm);
    grid->setHorizontalSpacing(3 * kRhythm);
    grid->setVerticalSpacing(kRhythm / 2);
    addHeading(*grid, QObject::tr("Anywhere"));
    for (const Command& command : commands())
        if (*command.keys) addRow(*grid, nativeKeys(command.keys), QObject::tr(command.sentence));
    addHeading(*grid, QObject::tr("In the view"));
    for (const Manner& manner : viewManners())
        addRow(*grid, QObject::tr(manner.keys), QObject::tr(manner.text));
    sheet->show();
}

} // namespace tactum
