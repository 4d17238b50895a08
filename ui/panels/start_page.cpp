#include "ui/panels/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/style.h"

namespace tactum {

namespace {

constexpr int kColumn = 60 * kRhythm; // pixels

QLabel* line(const QString& text, int points, bool dimmed) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setPointSize(font.pointSize() + points);
    label->setFont(font);
    label->setProperty("dimmed", dimmed);
    return label;
}

QString shortened(const QString& path) {
    const QString home = QDir::homePath();
    return path.startsWith(home + u'/') ? QStringLiteral("~") + path.mid(home.size()) : path;
}

} // namespace

StartPage::StartPage(const QString& sample, QWidget* parent) : QWidget(parent), recent_(new QWidget) {
    setObjectName(QStringLiteral("startPage"));
    setAttribute(Qt::WA_StyledBackground);
    auto* body = new QWidget;
    body->setFixedWidth(kColumn);
    column_ = new QVBoxLayout(body);
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(kRhythm);
    addHeading();
    addButtons(sample);
    column_->addSpacing(2 * kRhythm);
    column_->addWidget(recent_);
    new QVBoxLayout(recent_);
    auto* centred = new QVBoxLayout(this);
    centred->addStretch(2);
    centred->addWidget(body, 0, Qt::AlignHCenter);
    centred->addStretch(3);
}

void StartPage::addHeading() {
    auto* picture = new QLabel;
    picture->setPixmap(logo(64));
    picture->setFixedSize(64, 64);
    column_->addWidget(picture);
    column_->addSpacing(kRhythm);
    column_->addWidget(line(tr("Touch a model"), 11, false));
    auto* what = line(tr("Open a 3-D model, give each of its surfaces a feel, and touch it: with a "
                         "force-feedback device, or with the mouse as a simulated hand."),
                      1, true);
    what->setWordWrap(true);
    what->setFixedWidth(kColumn);
    what->setFixedHeight(what->heightForWidth(kColumn)); // layouts ask wrapped text too late
    column_->addWidget(what);
    column_->addSpacing(2 * kRhythm);
}

void StartPage::addButtons(const QString& sample) {
    auto* row = new QHBoxLayout;
    row->setSpacing(kRhythm);
    auto* open = new QPushButton(tr("Open a model..."));
    open->setProperty("primary", true);
    open->setObjectName(QStringLiteral("start-open"));
    connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
    row->addWidget(open);
    if (!sample.isEmpty()) {
        auto* button = new QPushButton(tr("Try the sample"));
        button->setObjectName(QStringLiteral("start-sample"));
        button->setToolTip(sample);
        connect(button, &QPushButton::clicked, this, [this, sample] { emit fileChosen(sample); });
        row->addWidget(button);
    }
    row->addStretch();
    column_->addLayout(row);
    column_->addWidget(line(tr("or drop a file on this window: OBJ, PLY, STL, OFF, glTF"), 0, true));
}

void StartPage::setRecent(const QStringList& files) {
    auto* list = static_cast<QVBoxLayout*>(recent_->layout());
    list->setContentsMargins(0, 0, 0, 0);
    list->setSpacing(0);
    qDeleteAll(recent_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    if (files.isEmpty()) return;
    list->addWidget(line(tr("Recent"), 0, true));
    for (const QString& file : files) {
        const QFileInfo info(file);
        auto* button =
            new QPushButton(icon(QStringLiteral("recent")),
                            QStringLiteral("%1   %2").arg(info.fileName(), shortened(info.path())));
        button->setProperty("link", true);
        connect(button, &QPushButton::clicked, this, [this, file] { emit fileChosen(file); });
        list->addWidget(button);
    }
}

} // namespace tactum
