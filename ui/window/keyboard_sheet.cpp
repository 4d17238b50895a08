#include "ui/window/keyboard_sheet.h"

#include <algorithm>
#include <vector>

#include <QDialog>
#include <QGridLayout>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/base/search.h"
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

/// The rows of a topic, seen where they have all that is searched for.
class Topic {
public:
    Topic(QGridLayout& grid, const QString& title) : grid_(grid), title_(title), heading_(new QLabel(title)) {
        heading_->setProperty("dimmed", true);
        heading_->setContentsMargins(0, kRhythm, 0, 0);
        grid_.addWidget(heading_, grid_.rowCount(), 0, 1, 2);
    }

    void add(const QString& keys, const QString& meaning) {
        const int row = grid_.rowCount();
        rows_.push_back({new QLabel(keys), new QLabel(meaning)});
        rows_.back().keys->setProperty("heading", true);
        grid_.addWidget(rows_.back().keys, row, 0, Qt::AlignTop);
        grid_.addWidget(rows_.back().meaning, row, 1);
    }

    /// Whether any row has all words, in its keys, its meaning, or the title above it.
    bool show(const QStringList& words) {
        bool any = false;
        for (const Row& row : rows_) {
            const QString text = QStringList{title_, row.keys->text(), row.meaning->text()}.join(u' ');
            const bool seen = hasWords(text, words);
            row.keys->setVisible(seen);
            row.meaning->setVisible(seen);
            any = any || seen;
        }
        heading_->setVisible(any);
        return any;
    }

private:
    struct Row {
        QLabel *keys, *meaning;
    };

    QGridLayout& grid_;
    QString title_;
    QLabel* heading_;
    std::vector<Row> rows_;
};

/// By menu, in the order of the table, and what the view does by itself.
std::vector<Topic> topicsIn(QGridLayout& grid) {
    std::vector<Topic> topics;
    QString menu;
    for (const Command& command : commands()) {
        if (!*command.keys) continue;
        const QString title = QString::fromLatin1(command.menu).section(u'/', 0, 0);
        if (title != menu) topics.emplace_back(grid, QObject::tr(qPrintable(title)).remove(u'&'));
        menu = title;
        topics.back().add(nativeKeys(command.keys), QObject::tr(command.sentence));
    }
    topics.emplace_back(grid, QObject::tr("In the view"));
    for (const Manner& manner : viewManners())
        topics.back().add(QObject::tr(manner.keys), QObject::tr(manner.text));
    return topics;
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
    sheet->setObjectName(QStringLiteral("keyboard-sheet"));
    sheet->setWindowTitle(QObject::tr("Keyboard and mouse"));
    auto* page = new QWidget;
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * kRhythm);
    grid->setVerticalSpacing(kRhythm / 2);
    auto* nothing = new QLabel(QObject::tr("No key and no gesture has these words."));
    nothing->setObjectName(QStringLiteral("nothing-found"));
    nothing->setProperty("dimmed", true);
    nothing->hide();
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(3 * kRhythm, 0, 3 * kRhythm, 3 * kRhythm);
    column->addLayout(grid);
    column->addWidget(nothing);
    column->addStretch();
    auto* field = new QLineEdit;
    field->setPlaceholderText(QObject::tr("Search keys and what they do"));
    field->setAccessibleName(field->placeholderText());
    field->setClearButtonEnabled(true);
    QObject::connect(field, &QLineEdit::textChanged, page,
                     [nothing, topics = topicsIn(*grid)](const QString& text) mutable {
                         const QStringList words = searchWords(text);
                         bool any = false;
                         for (Topic& topic : topics)
                             any = topic.show(words) || any;
                         nothing->setVisible(!any);
                     });
    auto* scroll = new QScrollArea;
    scroll->setAccessibleName(sheet->windowTitle());
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QVBoxLayout(sheet);
    all->setContentsMargins(0, 0, 0, 0);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(3 * kRhythm, 2 * kRhythm, 3 * kRhythm, kRhythm / 2);
    top->addWidget(field);
    all->addLayout(top);
    all->addWidget(scroll);
    const QSize room = parent->screen()->availableSize();
    const int wide = page->sizeHint().width() + scroll->verticalScrollBar()->sizeHint().width();
    sheet->resize(std::min(wide, room.width()),
                  std::min(page->sizeHint().height(), std::min(parent->height(), room.height())));
    sheet->show();
    field->setFocus();
}

} // namespace tactum
