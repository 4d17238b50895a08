#include "ui/study/study_panel.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/study/staircase_fields.h"
#include "ui/study/study_desk.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

namespace {

constexpr double kFeel = 4, kAnswer = 3; // s

QString procedureWords(const StudyDesign& design) {
    switch (design.procedure) {
    case Procedure::List:
        return StudyPanel::tr("Each condition by itself");
    case Procedure::Pairs:
        return StudyPanel::tr("Pairs, the better one is chosen");
    case Procedure::Abx:
        return StudyPanel::tr("A/B/X");
    case Procedure::Staircase:
        break;
    }
    const auto bent = valueOf(design.staircase);
    return StudyPanel::tr("Staircase, %1 down 1 up, over %2")
        .arg(design.staircase.down)
        .arg(bent ? wordsFor(*bent) : QStringLiteral("?"));
}

} // namespace

double expectedSeconds(const StudyDesign& design) {
    const double interval = design.stimulusSeconds > 0 ? design.stimulusSeconds : kFeel;
    const double answers =
        kAnswer * (double(design.questions.size()) + (design.procedure == Procedure::List ? 0 : 1));
    return trialsOf(design) * (intervalsOf(design) * interval + answers + design.pauseSeconds);
}

QString summaryOf(const StudyDesign& design) {
    QStringList lines{procedureWords(design)};
    const bool most = design.procedure == Procedure::Staircase;
    const int trials = trialsOf(design);
    lines << (most ? StudyPanel::tr("At most %n trial(s)", nullptr, trials)
                   : StudyPanel::tr("%n trial(s)", nullptr, trials)) +
                 StudyPanel::tr(", about %1 min").arg(int(std::ceil(expectedSeconds(design) / 60)));
    lines << StudyPanel::tr("%n question(s) after each", nullptr, int(design.questions.size()));
    if (const auto sound = check(design); !sound)
        lines << QString::fromStdString(sound.error().text);
    else if (design.procedure == Procedure::List && design.questions.empty())
        lines << StudyPanel::tr("Nothing is asked of the participant; questions are in Procedure.");
    return lines.join(u'\n');
}

StudyPanel::StudyPanel(StudyDesk& desk, QWidget* parent)
    : QWidget(parent), desk_(desk),
      list_(new HintedTree(tr("No condition yet. Make the scene feel as one should, then keep this state."))),
      summary_(new QLabel) {
    setAttribute(Qt::WA_StyledBackground);
    auto* buttons = new QGridLayout; // in two columns: the view keeps its room
    buttons->setSpacing(kRhythm / 2);
    auto* whole = new QHBoxLayout(this);
    whole->setContentsMargins(12, kRhythm / 2, 12, kRhythm / 2);
    whole->setSpacing(kRhythm);
    auto* told = new QVBoxLayout;
    told->addWidget(list_, 1);
    told->addWidget(summary_);
    whole->addLayout(told, 1);
    whole->addLayout(buttons);
    keep_ = addButton(tr("Keep this state..."), "study-keep-button",
                      tr("The scene as it is now becomes a condition, under a name"), &StudyPanel::keepAsked);
    replace_ =
        addButton(tr("Replace"), "study-replace-button",
                  tr("The chosen condition becomes the scene as it is now"), &StudyPanel::replaceAsked);
    show_ =
        addButton(tr("Show"), "study-show-button",
                  tr("The scene becomes the chosen condition; Undo takes it back"), &StudyPanel::showAsked);
    remove_ =
        addButton(tr("Remove"), "study-remove-button",
                  tr("The chosen condition is no part of the study any more"), &StudyPanel::removeAsked);
    edit_ = addButton(tr("Procedure..."), "study-edit-button",
                      tr("What a trial is, in which order trials come, and what is asked"),
                      &StudyPanel::editAsked);
    run_ = addButton(tr("Run..."), "study-run-button",
                     tr("With a participant, whose answers and touch are logged"), &StudyPanel::runAsked);
    buttons->setRowStretch(buttons->rowCount(), 1);
    list_->setObjectName(QStringLiteral("study-conditions"));
    list_->setMinimumWidth(6 * kRhythm);
    list_->setAccessibleName(tr("Conditions of the study"));
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    summary_->setObjectName(QStringLiteral("study-summary"));
    summary_->setTextFormat(Qt::PlainText);
    summary_->setWordWrap(true);
    summary_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    connect(list_, &QTreeWidget::currentItemChanged, this, &StudyPanel::showChosen);
    connect(list_, &QTreeWidget::itemChanged, this, &StudyPanel::rename);
    connect(&desk_, &StudyDesk::changed, this, &StudyPanel::refresh);
    refresh();
}

QPushButton* StudyPanel::addButton(const QString& text, const char* name, const QString& meaning,
                                   void (StudyPanel::*asked)()) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(meaning);
    button->setProperty("inRow", true); // the window has to fit a small screen
    connect(button, &QPushButton::clicked, this, asked);
    auto* buttons = static_cast<QGridLayout*>(layout()->itemAt(1)->layout());
    buttons->addWidget(button, buttons->count() % 3, buttons->count() / 3);
    return button;
}

int StudyPanel::chosen() const {
    return list_->indexOfTopLevelItem(list_->currentItem());
}

void StudyPanel::setSceneThere(bool there) {
    keep_->setEnabled(there);
}

void StudyPanel::refresh() {
    const StudyDesign& design = desk_.study().design;
    const int row = chosen(), before = list_->topLevelItemCount();
    filling_ = true;
    list_->clear();
    for (const std::string& name : design.conditions) {
        auto* item = new QTreeWidgetItem(list_, {QString::fromStdString(name)});
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    filling_ = false;
    const int count = list_->topLevelItemCount();
    const int next =
        row < 0 || count > before ? count - 1 : std::min(row, count - 1); // the newest when it came
    if (count > 0) list_->setCurrentItem(list_->topLevelItem(next));
    summary_->setText(summaryOf(design));
    run_->setEnabled(check(design).has_value());
    showChosen();
}

void StudyPanel::rename(QTreeWidgetItem* item) {
    if (filling_) return;
    if (!desk_.rename(list_->indexOfTopLevelItem(item), item->text(0))) refresh();
}

void StudyPanel::showChosen() {
    for (QPushButton* each : {replace_, show_, remove_})
        each->setEnabled(chosen() >= 0);
    if (!filling_) emit chosenChanged();
}

} // namespace tactum
