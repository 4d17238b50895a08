#include "ui/widgets/command_palette.h"

#include <algorithm>
#include <tuple>

#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr int kWidth = 76 * kRhythm, kHeight = 52 * kRhythm; // pixels
constexpr qsizetype kRemembered = 8;
const auto kRecentKey = QStringLiteral("palette/recent");

QStringList recentCommands() {
    return QSettings().value(kRecentKey).toStringList();
}

void remember(const QString& id) {
    if (id.isEmpty()) return;
    QStringList ids = recentCommands();
    ids.removeAll(id);
    ids.prepend(id);
    QSettings().setValue(kRecentKey, QStringList(ids.mid(0, kRemembered)));
}

bool beginsWord(const QString& text, const QString& word) {
    for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1))
        if (at == 0 || !text[at - 1].isLetterOrNumber()) return true;
    return false;
}

/// Its letters in their order, with others between.
bool hasLetters(const QString& text, const QString& word) {
    qsizetype at = 0;
    for (const QChar c : word) {
        at = text.indexOf(c, at) + 1;
        if (at == 0) return false;
    }
    return true;
}

constexpr int kItsName = 64; ///< above whatever has the words in it

int scoreOfWord(const QString& word, const PaletteEntry& entry) {
    const QString text = entry.text.toCaseFolded();
    if (beginsWord(text, word)) return 16;
    if (text.contains(word)) return 8;
    if (beginsWord(entry.menu.toCaseFolded(), word)) return 4;
    if (beginsWord(entry.sentence.toCaseFolded(), word) || entry.keys.toCaseFolded() == word) return 2;
    return hasLetters(text, word) ? 1 : 0;
}

} // namespace

int paletteScore(const QString& typed, const PaletteEntry& entry) {
    int score = 1;
    for (const QString& word : typed.toCaseFolded().split(u' ', Qt::SkipEmptyParts)) {
        const int more = scoreOfWord(word, entry);
        if (more == 0) return 0;
        score += more;
    }
    return typed.trimmed().toCaseFolded() == entry.text.toCaseFolded() ? score + kItsName : score;
}

std::vector<std::size_t> paletteOrder(const QString& typed, const std::vector<PaletteEntry>& entries,
                                      const QStringList& recent) {
    struct Match {
        bool off; ///< cannot be run as things are, and is not asked for by its name
        int score;
        qsizetype age; ///< 0: run last
        std::size_t index;
    };
    std::vector<Match> places;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const qsizetype age = entries[i].id.isEmpty() ? -1 : recent.indexOf(entries[i].id);
        if (const int score = paletteScore(typed, entries[i]))
            places.push_back(
                {!entries[i].whyNot.isEmpty() && score < kItsName, score, age < 0 ? recent.size() : age, i});
    }
    std::ranges::stable_sort(places, [](const Match& a, const Match& b) {
        return std::tuple(a.off, -a.score, a.age) < std::tuple(b.off, -b.score, b.age);
    });
    std::vector<std::size_t> order;
    for (const Match& place : places)
        order.push_back(place.index);
    return order;
}

CommandPalette::CommandPalette(std::vector<PaletteEntry> entries, QWidget* parent)
    : QFrame(parent, Qt::Popup), entries_(std::move(entries)), line_(new QLineEdit), list_(new QTreeWidget),
      sentence_(new QLabel) {
    setObjectName(QStringLiteral("palette"));
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName(tr("Commands"));
    line_->setObjectName(QStringLiteral("palette-line"));
    line_->setPlaceholderText(tr("What do you want to do?"));
    line_->setAccessibleName(tr("Search for a command"));
    line_->setClearButtonEnabled(true);
    line_->installEventFilter(this);
    list_->setObjectName(QStringLiteral("palette-list"));
    list_->setAccessibleName(tr("Commands that fit"));
    list_->setColumnCount(3);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setFocusPolicy(Qt::NoFocus); // the line has the keys
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    sentence_->setObjectName(QStringLiteral("palette-sentence"));
    sentence_->setProperty("dimmed", true);
    sentence_->setWordWrap(true);
    sentence_->setMinimumHeight(2 * sentence_->fontMetrics().lineSpacing());
    sentence_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kRhythm, kRhythm, kRhythm, kRhythm);
    column->setSpacing(kRhythm);
    for (QWidget* part :
         {static_cast<QWidget*>(line_), static_cast<QWidget*>(list_), static_cast<QWidget*>(sentence_)})
        column->addWidget(part);
    connect(line_, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(list_, &QTreeWidget::currentItemChanged, this, &CommandPalette::explain);
    connect(list_, &QTreeWidget::itemClicked, this, &CommandPalette::runCurrent);
    fill();
}

void CommandPalette::open() {
    const QWidget& window = *parentWidget();
    resize(std::min(kWidth, window.width() - 2 * kRhythm), std::min(kHeight, window.height() - 8 * kRhythm));
    move(window.mapToGlobal(QPoint((window.width() - width()) / 2, 5 * kRhythm)));
    show();
    line_->setFocus();
}

void CommandPalette::fill() {
    list_->clear();
    sourced_ = source_ ? source_(line_->text()) : std::vector<PaletteEntry>();
    for (std::size_t i = 0; i < sourced_.size(); ++i)
        addRow(sourced_[i], entries_.size() + i);
    for (const std::size_t index : paletteOrder(line_->text(), entries_, recentCommands()))
        addRow(entries_[index], index);
    list_->setCurrentItem(list_->topLevelItem(0));
    explain();
}

void CommandPalette::addRow(const PaletteEntry& entry, std::size_t index) {
    QString where = entry.menu;
    if (entry.on) where = *entry.on ? tr("%1 (on)").arg(where) : tr("%1 (off)").arg(where);
    auto* item = new QTreeWidgetItem(list_, {entry.text, where, entry.keys});
    item->setData(0, Qt::UserRole, qulonglong(index));
    item->setData(
        0, Qt::AccessibleTextRole,
        QStringList({entry.text, where, entry.keys, entry.whyNot.isEmpty() ? entry.sentence : entry.whyNot})
            .join(QStringLiteral(", ")));
    for (int i = 0; i < 3; ++i)
        if (i > 0 || !entry.whyNot.isEmpty()) item->setForeground(i, theme().textDimmed);
}

const PaletteEntry* CommandPalette::current() const {
    const QTreeWidgetItem* item = list_->currentItem();
    if (!item) return nullptr;
    const std::size_t index = item->data(0, Qt::UserRole).toULongLong();
    return index < entries_.size() ? &entries_[index] : &sourced_[index - entries_.size()];
}

void CommandPalette::explain() {
    const PaletteEntry* entry = current();
    if (!entry) return sentence_->setText(tr("No command fits; leave some letters out."));
    sentence_->setText(entry->whyNot.isEmpty() ? entry->sentence
                                               : tr("Not now: %1 %2").arg(entry->whyNot, entry->sentence));
}

void CommandPalette::runCurrent() {
    const PaletteEntry* entry = current();
    if (!entry || !entry->whyNot.isEmpty()) return; // the sentence says so
    remember(entry->id);
    // The window has the keys back before the command begins, which may open a dialog.
    QTimer::singleShot(0, parentWidget(), entry->run);
    close();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
    auto* key = static_cast<QKeyEvent*>(event);
    switch (key->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        QCoreApplication::sendEvent(list_, event);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        runCurrent();
        return true;
    case Qt::Key_Escape:
        close();
        return true;
    default:
        return QFrame::eventFilter(watched, event);
    }
}

} // namespace tactum
