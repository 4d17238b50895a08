#include "ui/study/study_page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/base/style.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

constexpr int kLarge = 12, kHuge = 20; // points more than elsewhere

QLabel* labelOf(const char* name, int points) {
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setTextFormat(Qt::PlainText); // it is the author's
    label->setFont(figureFont(points));
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

/// What an interval is called to the participant.
QString intervalName(const StudyRun& run, int interval) {
    if (run.design().procedure == Procedure::Abx) return QStringLiteral("ABX").mid(interval, 1);
    const int count = intervalsOf(run.design());
    return count == 1 ? StudyPage::tr("Stimulus")
                      : StudyPage::tr("Stimulus %1 of %2").arg(interval + 1).arg(count);
}

} // namespace

StudyPage::StudyPage(QWidget* parent)
    : QWidget(parent), head_(labelOf("study-head", kHuge)), text_(labelOf("study-text", kLarge)),
      low_(labelOf("study-low", 4)), high_(labelOf("study-high", 4)), note_(labelOf("study-note", 4)),
      field_(new QLineEdit), buttons_(new QHBoxLayout), scale_(new QWidget) {
    setObjectName(QStringLiteral("study-page"));
    setAttribute(Qt::WA_StyledBackground);
    setAutoFillBackground(true);
    setFocusPolicy(Qt::StrongFocus);
    field_->setObjectName(QStringLiteral("study-field"));
    field_->setFont(figureFont(kLarge));
    field_->setAccessibleName(tr("Answer"));
    field_->setMaximumWidth(80 * kRhythm);
    field_->installEventFilter(this);
    auto* row = new QHBoxLayout(scale_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kRhythm);
    row->addStretch();
    row->addWidget(low_);
    row->addLayout(buttons_);
    row->addWidget(high_);
    row->addStretch();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4 * kRhythm, 2 * kRhythm, 4 * kRhythm, 2 * kRhythm);
    column->setSpacing(2 * kRhythm);
    column->addStretch();
    for (QWidget* each : {static_cast<QWidget*>(head_), static_cast<QWidget*>(text_)})
        column->addWidget(each);
    column->addWidget(field_, 0, Qt::AlignHCenter);
    column->addWidget(scale_);
    column->addWidget(note_);
    column->addStretch();
    hide();
}

void StudyPage::display(const StudyRun& run, const StudyMoment& moment) {
    run_ = run;
    moment_ = moment;
    showAgain();
}

void StudyPage::askToEnd() {
    if (!run_ || ending_) return;
    ending_ = true;
    showAgain();
}

void StudyPage::refuse(const QString& sentence) {
    note_->setText(sentence);
    note_->show();
}

void StudyPage::showAgain() {
    if (ending_) return showEnd();
    switch (run_->step()) {
    case StudyStep::Instructions:
        return showInstructions();
    case StudyStep::Stimulus:
        return showStimulus();
    case StudyStep::Choice:
        return showChoice();
    case StudyStep::Question:
        return showQuestion();
    case StudyStep::Pause:
        return moment_.resting ? show(tr("A pause"), tr("It goes on by itself."), {})
                               : show(tr("A pause"), {}, {goOn(tr("Go on (Space)"))});
    case StudyStep::Done:
        return show(tr("That was all. Thank you."), {}, {goOn(tr("Close (Space)"))});
    }
}

StudyPage::Way StudyPage::goOn(const QString& text) {
    return {text, Qt::Key_Space, [this] { emit proceeded(); }};
}

void StudyPage::showInstructions() {
    const QString text = asIs(run_->design().instructions);
    const QString always = tr("Take the handle in your hand. The forces come on when you begin.");
    show(tr("Welcome"), text.isEmpty() ? always : text + QStringLiteral("\n\n") + always,
         {goOn(tr("Begin (Space)"))});
}

void StudyPage::showStimulus() {
    const bool free = run_->design().view != StudyView::Hidden;
    const QString name = intervalName(*run_, run_->interval());
    if (moment_.lift) return show(name, tr("Lift off until you touch nothing."), {}, free);
    if (!moment_.felt) return show(name, tr("One moment."), {}, free);
    if (!moment_.forces)
        return show(
            name, tr("The forces are off. Take the handle in your hand."),
            {{tr("Forces on (F)"), Qt::Key_F, [this] { emit forcesWanted(); }}, goOn(tr("Next (Space)"))},
            free);
    show(name, tr("Touch it."), {goOn(tr("Next (Space)"))}, free);
}

void StudyPage::showChoice() {
    std::vector<Way> ways;
    const std::vector<std::string> choices = choicesOf(run_->design());
    for (int i = 0; i < int(choices.size()); ++i) {
        const QString name = wordsOf(choices[std::size_t(i)]);
        ways.push_back({name.size() > 1 ? tr("%1 (%2)").arg(name, name.left(1)) : name, name.at(0).unicode(),
                        [this, i] { emit chosen(i); }});
    }
    if (run_->design().again)
        ways.push_back({tr("Feel again (R)"), Qt::Key_R, [this] { emit againWanted(); }});
    show(wordsOf(promptOf(run_->design())), {}, std::move(ways));
}

void StudyPage::showQuestion() {
    const StudyQuestion& question = run_->design().questions[std::size_t(run_->question())];
    if (question.kind == StudyQuestion::Kind::Rating) return showRating(question);
    if (question.kind != StudyQuestion::Kind::Choice) return showField(question);
    std::vector<Way> ways;
    for (const std::string& choice : question.choices) {
        const QString name = asIs(choice);
        const int key = Qt::Key_1 + int(ways.size());
        ways.push_back(
            {tr("%1 (%2)").arg(name).arg(ways.size() + 1), key, [this, name] { emit replied(name); }});
    }
    show(asIs(question.text), {}, std::move(ways));
}

void StudyPage::showRating(const StudyQuestion& question) {
    std::vector<Way> ways;
    for (int i = 1; i <= question.steps; ++i) // 0 is ten
        ways.push_back({QString::number(i),
                        i < 10    ? Qt::Key_0 + i
                        : i == 10 ? Qt::Key_0
                                  : 0,
                        [this, i] { emit replied(QString::number(i)); }});
    show(asIs(question.text), {}, std::move(ways));
    low_->setText(asIs(question.low));
    high_->setText(asIs(question.high));
    low_->setVisible(!question.low.empty());
    high_->setVisible(!question.high.empty());
}

void StudyPage::showField(const StudyQuestion& question) {
    show(asIs(question.text),
         question.kind == StudyQuestion::Kind::Magnitude ? tr("Type a number above 0, then Enter.")
                                                         : tr("Type, then Enter."),
         {});
    field_->setVisible(true);
    field_->setAccessibleName(asIs(question.text));
    field_->setFocus();
}

void StudyPage::showEnd() {
    const auto back = [this] {
        ending_ = false;
        showAgain();
    };
    const auto end = [this] {
        ending_ = false;
        emit endWanted();
    };
    show(tr("End the study?"), tr("What was answered so far is kept, and the run can be gone on with."),
         {{tr("Go on (Space)"), Qt::Key_Space, back}, {tr("End it (E)"), Qt::Key_E, end}});
}

void StudyPage::show(const QString& head, const QString& text, std::vector<Way> ways, bool leavesView) {
    qDeleteAll(shown_);
    shown_.clear();
    ways_ = std::move(ways);
    for (const Way& way : ways_) {
        auto* button = shown_.emplace_back(new QPushButton(way.text));
        button->setFont(figureFont(kLarge));
        button->setFocusPolicy(Qt::NoFocus); // keys are the page's
        // Later: the button may be gone by what it does.
        connect(button, &QPushButton::clicked, this, way.act, Qt::QueuedConnection);
        buttons_->addWidget(button);
        button->show();
    }
    head_->setText(head);
    text_->setText(text);
    text_->setVisible(!text.isEmpty());
    for (QLabel* each : {low_, high_, note_}) {
        each->clear(); // nothing of the step before
        each->hide();
    }
    field_->hide();
    field_->clear();
    setAccessibleName(words());
    QWidget::show();
    setFocus();
    if (leavesView_ == leavesView) return;
    leavesView_ = leavesView;
    emit leavesViewChanged(leavesView);
}

QString StudyPage::words() const {
    QStringList all{head_->text(), text_->text()};
    for (const Way& way : ways_)
        all << way.text;
    return all.join(u'\n');
}

void StudyPage::keyPressEvent(QKeyEvent* event) {
    if (event->isAutoRepeat()) return;
    if (event->key() == Qt::Key_Escape) return askToEnd();
    const int key =
        event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter ? Qt::Key_Space : event->key();
    for (const Way& way : ways_)
        if (way.key == key) {
            const auto act = way.act; // the ways are others afterwards
            return act();
        }
}

/// Keys of the field that do something go no further: on the page that comes next they would do something
/// again.
bool StudyPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched != field_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const auto* pressed = static_cast<const QKeyEvent*>(event);
    const bool answers = pressed->key() == Qt::Key_Return || pressed->key() == Qt::Key_Enter;
    if (answers && !pressed->isAutoRepeat()) emit replied(field_->text());
    if (pressed->key() == Qt::Key_Escape) askToEnd();
    return answers || pressed->key() == Qt::Key_Escape;
}

} // namespace tactum
