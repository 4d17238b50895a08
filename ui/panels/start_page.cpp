#include "ui/panels/start_page.h"

#include <map>

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/base/style.h"
#include "ui/panels/recent_list.h"
#include "ui/panels/sample_gallery.h"

namespace tactum {

namespace {

constexpr int kWidest = 156 * kRhythm, kMargin = 3 * kRhythm, kLogo = 48; // pixels

QLabel* line(const QString& text, int points, bool dimmed) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setPointSize(font.pointSize() + points);
    label->setFont(font);
    label->setProperty("dimmed", dimmed);
    return label;
}

QString headingOf(bool moves, std::size_t groups) {
    if (groups < 2) return StartPage::tr("Samples");
    return moves ? StartPage::tr("Samples: moving worlds") : StartPage::tr("Samples: surfaces");
}

} // namespace

StartPage::StartPage(const QStringList& samples, QWidget* parent) : QWidget(parent), recent_(new RecentList) {
    setObjectName(QStringLiteral("startPage"));
    setAttribute(Qt::WA_StyledBackground);
    auto* body = new QWidget;
    body->setMaximumWidth(kWidest);
    body->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    column_ = new QVBoxLayout(body);
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(kRhythm);
    addHeading();
    addButtons();
    column_->addSpacing(kRhythm);
    column_->addWidget(recent_);
    connect(recent_, &RecentList::fileChosen, this, &StartPage::fileChosen);
    if (!samples.isEmpty()) addSamples(samples);
    auto* page = new QWidget;
    auto* across = new QHBoxLayout;
    across->setContentsMargins(kMargin, 0, kMargin, 0);
    across->addStretch(1);
    across->addWidget(body, 1000);
    across->addStretch(1);
    auto* centred = new QVBoxLayout(page);
    centred->addSpacing(5 * kRhythm); // for what lies over the page: who has lost work reads two headings
    centred->addStretch(2);
    centred->addLayout(across);
    centred->addStretch(3);
    auto* scrolled = new QScrollArea; // a small window stays small
    scrolled->setWidgetResizable(true);
    scrolled->setFocusPolicy(Qt::NoFocus); // it follows the button that has the keys
    scrolled->setWidget(page);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scrolled);
}

void StartPage::addHeading() {
    auto* picture = new QLabel;
    picture->setPixmap(logo(kLogo));
    picture->setFixedSize(kLogo, kLogo);
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * kRhythm);
    row->addWidget(picture);
    row->addWidget(line(tr("Touch a model"), 11, false), 1);
    column_->addLayout(row);
    auto* what = line(tr("Open a 3-D model, give each of its surfaces a feel, and touch it: with a "
                         "force-feedback device, or with the mouse as a simulated hand."),
                      1, true);
    what->setWordWrap(true);
    column_->addWidget(what);
    column_->addSpacing(kRhythm);
}

void StartPage::addButtons() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kRhythm);
    auto* open = new QPushButton(tr("Open a model..."));
    open->setProperty("primary", true);
    open->setObjectName(QStringLiteral("start-open"));
    connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
    row->addWidget(open);
    auto* begin = new QPushButton(tr("New scene"));
    begin->setObjectName(QStringLiteral("start-new"));
    begin->setToolTip(tr("A ground to put several models on"));
    connect(begin, &QPushButton::clicked, this, &StartPage::newRequested);
    row->addWidget(begin);
    row->addStretch();
    column_->addLayout(row);
    column_->addWidget(
        line(tr("or drop files on this window: OBJ, PLY, STL, OFF, glTF, X3D, FBX, DAE, 3DS, 3MF"), 0, true));
}

void StartPage::addSamples(const QStringList& samples) {
    std::map<QString, QStringList> groups; // by folder: surfaces first, what moves in a folder below
    for (const QString& sample : samples)
        groups[QFileInfo(sample).path()] << sample;
    for (const auto& [folder, files] : groups) {
        auto* gallery = new SampleGallery(files);
        connect(gallery, &SampleGallery::fileChosen, this, &StartPage::fileChosen);
        const bool moves = folder.endsWith(QStringLiteral("/moving"));
        column_->addSpacing(2 * kRhythm);
        column_->addWidget(line(headingOf(moves, groups.size()), 0, true));
        column_->addWidget(gallery);
    }
}

} // namespace tactum
