#include "ui/panels/recent_list.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/base/style.h"
#include "ui/document/recent_pictures.h"
#include "ui/widgets/picture_card.h"

namespace tactum {

namespace {

QString folderOf(const QString& file) {
    const QString folder = QFileInfo(file).path(), home = QDir::homePath();
    return folder == home || folder.startsWith(home + u'/') ? u'~' + folder.mid(home.size()) : folder;
}

QString whenOf(const QDateTime& opened) {
    const QString time = opened.toString(QStringLiteral("HH:mm"));
    const QDate today = QDate::currentDate();
    if (opened.date() == today) return RecentList::tr("today at %1").arg(time);
    if (opened.date() == today.addDays(-1)) return RecentList::tr("yesterday at %1").arg(time);
    return opened.date().toString(Qt::ISODate); // empty where nobody noted it
}

QStringList detailsOf(const RecentFile& file, const QString& found) {
    QStringList details{folderOf(file.path), whenOf(file.opened), found};
    details.removeAll(QString());
    if (details.size() == 1) details << QString(); // a folder is no sentence, which would be wrapped
    return details;
}

} // namespace

RecentList::RecentList(QWidget* parent) : QWidget(parent), grid_(new CardGrid) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* heading = new QLabel(tr("Recent"));
    heading->setProperty("dimmed", true);
    column->addWidget(heading);
    column->addWidget(grid_);
    hide();
}

PictureCard* RecentList::cardOf(const RecentFile& file) {
    const QString name = QFileInfo(file.path).fileName();
    auto* card = new PictureCard(name);
    card->setObjectName(QStringLiteral("recent-") + name);
    card->setToolTip(file.path);
    card->setDetails(detailsOf(file, {}));
    connect(card, &PictureCard::clicked, this, [this, path = file.path] { emit fileChosen(path); });
    auto* away = new QToolButton;
    away->setObjectName(QStringLiteral("recent-remove"));
    away->setIcon(icon(QStringLiteral("close")));
    away->setToolTip(tr("Remove from the list; the file stays"));
    away->setAccessibleName(tr("Remove %1 from the list").arg(name));
    away->setFocusPolicy(Qt::StrongFocus);
    connect(away, &QToolButton::clicked, this, [this, path = file.path] { emit removeAsked(path); });
    auto* row = new QHBoxLayout(card);
    row->setContentsMargins(0, kRhythm / 2, kRhythm / 2, 0);
    row->addStretch();
    row->addWidget(away, 0, Qt::AlignTop);
    return card;
}

int RecentList::focused() const {
    const QWidget* keys = window()->focusWidget();
    const auto has = [&](const QWidget* card) { return keys && (card == keys || card->isAncestorOf(keys)); };
    return int(std::ranges::find_if(cards_, has) - cards_.begin());
}

void RecentList::setFiles(const QList<RecentFile>& files) {
    const qsizetype before = focused();
    const bool hadKeys = before < cards_.size();
    files_ = files;
    grid_->clear();
    cards_.clear();
    for (const RecentFile& file : files) {
        cards_ << cardOf(file);
        grid_->add(cards_.back());
    }
    setVisible(!files.isEmpty());
    if (!hadKeys || cards_.isEmpty()) return;
    PictureCard& next = *cards_[std::min(before, cards_.size() - 1)];
    next.show(); // a layout does it later, and what is hidden gets no keys
    next.setFocus(Qt::OtherFocusReason);
}

void RecentList::setLooks(const QList<RecentLook>& looks) {
    for (const RecentLook& look : looks) {
        const auto file = std::ranges::find(files_, look.path, &RecentFile::path);
        if (file == files_.end()) continue;
        PictureCard& card = *cards_[file - files_.begin()];
        card.setPicture(QPixmap::fromImage(look.picture));
        card.setDetails(detailsOf(*file, look.gone      ? tr("It is no longer there")
                                         : look.changed ? tr("Changed since by another program")
                                                        : QString()));
    }
}

} // namespace tactum
