#include "ui/study/study_dialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/study/staircase_fields.h"
#include "ui/study/study_panel.h"

namespace tactum {

namespace {

/// One question a line: kind | text | more.
QString lineOf(const StudyQuestion& question) {
    QStringList parts{QString::fromLatin1(kQuestionNames[int(question.kind)]), asIs(question.text)};
    if (question.kind == StudyQuestion::Kind::Rating)
        parts << QString::number(question.steps) << asIs(question.low) << asIs(question.high);
    for (const std::string& choice : question.choices)
        if (question.kind == StudyQuestion::Kind::Choice) parts << asIs(choice);
    while (!parts.isEmpty() && parts.back().isEmpty())
        parts.removeLast();
    return parts.join(QStringLiteral(" | "));
}

std::optional<StudyQuestion> questionOf(const QString& line) {
    QStringList parts = line.split(u'|');
    for (QString& part : parts)
        part = part.trimmed();
    StudyQuestion question;
    const auto kind = std::ranges::find(kQuestionNames, parts[0].toLower().toStdString());
    if (kind == std::end(kQuestionNames) || parts.size() < 2) return {};
    question.kind = StudyQuestion::Kind(kind - std::begin(kQuestionNames));
    question.text = parts[1].toStdString();
    if (question.kind == StudyQuestion::Kind::Rating) {
        if (parts.size() > 2) question.steps = parts[2].toInt();
        question.low = parts.value(3).toStdString();
        question.high = parts.value(4).toStdString();
    } else if (question.kind == StudyQuestion::Kind::Choice) {
        for (const QString& choice : parts.mid(2))
            question.choices.push_back(choice.toStdString());
    }
    return question;
}

class DesignDialog : public QDialog {
public:
    DesignDialog(QWidget* parent, const StudyDesign& now, const std::vector<Scene>& conditions)
        : QDialog(parent), design_(now),
          buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
        setObjectName(QStringLiteral("study-dialog"));
        setWindowTitle(QObject::tr("Procedure and questions"));
        content_ = new QWidget;
        auto* columns = new QHBoxLayout(content_);
        columns->setContentsMargins({});
        columns->setSpacing(3 * kRhythm);
        columns->addWidget(makeProcedure());
        columns->addWidget(makeStaircase(conditions));
        columns->addWidget(makeQuestions());
        scrolled_ = new QScrollArea;
        scrolled_->setFrameShape(QFrame::NoFrame);
        scrolled_->setWidgetResizable(true);
        scrolled_->setWidget(content_);
        auto* rows = new QVBoxLayout(this);
        rows->addWidget(scrolled_, 1);
        summary_ = new QLabel;
        summary_->setObjectName(QStringLiteral("study-dialog-summary"));
        summary_->setTextFormat(Qt::PlainText);
        summary_->setWordWrap(true);
        rows->addWidget(summary_);
        rows->addWidget(buttons_);
        connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
        connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
        judge();
    }

    const StudyDesign& design() const { return design_; }
    /// All of it where the screen has room; what has none is scrolled to.
    QSize sizeHint() const override {
        const QSize all = QDialog::sizeHint() - scrolled_->sizeHint() + content_->sizeHint();
        return all.boundedTo(screen()->availableSize());
    }

private:
    QLineEdit* line(const char* name, const std::string& text) {
        auto* edit = new QLineEdit(asIs(text));
        edit->setObjectName(QString::fromLatin1(name));
        connect(edit, &QLineEdit::textChanged, this, [this] { judge(); });
        return edit;
    }
    QComboBox* box(const char* name, const QStringList& texts, int now) {
        auto* combo = new QComboBox;
        combo->setObjectName(QString::fromLatin1(name));
        combo->addItems(texts);
        combo->setCurrentIndex(now);
        connect(combo, &QComboBox::currentIndexChanged, this, [this] { judge(); });
        return combo;
    }
    QSpinBox* whole(const char* name, int least, int most, int now) {
        auto* spin = new QSpinBox;
        spin->setObjectName(QString::fromLatin1(name));
        spin->setRange(least, most);
        spin->setValue(now);
        connect(spin, &QSpinBox::valueChanged, this, [this] { judge(); });
        return spin;
    }
    QDoubleSpinBox* number(const char* name, double most, double now, int decimals,
                           const QString& unit = {}) {
        auto* spin = new QDoubleSpinBox;
        spin->setObjectName(QString::fromLatin1(name));
        spin->setDecimals(decimals);
        spin->setRange(0, most);
        spin->setValue(now);
        if (!unit.isEmpty()) spin->setSuffix(u' ' + unit);
        connect(spin, &QDoubleSpinBox::valueChanged, this, [this] { judge(); });
        return spin;
    }
    QCheckBox* check(const char* name, const QString& text, bool on) {
        auto* tick = new QCheckBox(text);
        tick->setObjectName(QString::fromLatin1(name));
        tick->setChecked(on);
        connect(tick, &QCheckBox::toggled, this, [this] { judge(); });
        return tick;
    }
    QPlainTextEdit* text(const char* name, const QString& words, int rows) {
        auto* edit = new QPlainTextEdit(words);
        edit->setObjectName(QString::fromLatin1(name));
        edit->setTabChangesFocus(true);
        edit->setFixedHeight(rows * 3 * kRhythm);
        connect(edit, &QPlainTextEdit::textChanged, this, [this] { judge(); });
        return edit;
    }

    QWidget* makeProcedure() {
        auto* group = new QGroupBox(QObject::tr("Procedure"));
        auto* form = new QFormLayout(group);
        form->addRow(QObject::tr("Name"), name_ = line("study-name", design_.name));
        form->addRow(
            QObject::tr("Kind"),
            kind_ = box("study-kind",
                        {QObject::tr("Each condition by itself"), QObject::tr("Pairs: one of two is chosen"),
                         QObject::tr("A/B/X: which one is X?"), QObject::tr("Staircase over a parameter")},
                        int(design_.procedure)));
        form->addRow(QObject::tr("Order"),
                     order_ = box("study-order",
                                  {QObject::tr("As listed"), QObject::tr("Random in each repetition"),
                                   QObject::tr("Balanced Latin square")},
                                  int(design_.order)));
        form->addRow(QObject::tr("Repetitions"),
                     repeats_ = whole("study-repeats", 1, kMaxRepetitions, design_.repeats));
        form->addRow(QObject::tr("Seed"),
                     seed_ = line("study-seed", design_.seed ? std::to_string(design_.seed) : std::string()));
        seed_->setPlaceholderText(QObject::tr("another one for each run"));
        form->addRow(QObject::tr("Choice asked"), prompt_ = line("study-prompt", design_.prompt));
        form->addRow(QObject::tr("Stimulus lasts"),
                     stimulus_ =
                         number("study-seconds", 3600, design_.stimulusSeconds, 1, QStringLiteral("s")));
        stimulus_->setSpecialValueText(QObject::tr("until the participant goes on"));
        form->addRow(QObject::tr("Pause after a trial"),
                     pause_ = number("study-pause", 3600, design_.pauseSeconds, 1, QStringLiteral("s")));
        form->addRow(QObject::tr("View"),
                     view_ = box("study-view",
                                 {QObject::tr("Shown, the finger on the surface"),
                                  QObject::tr("Frozen, without a finger"), QObject::tr("Hidden")},
                                 int(design_.view)));
        form->addRow(again_ = check("study-again", QObject::tr("Stimuli may be felt again before the choice"),
                                    design_.again));
        form->addRow(between_ = check("study-between", QObject::tr("Forces off while something is asked"),
                                      design_.forcesOffBetween));
        form->addRow(QObject::tr("Log every"), every_ = whole("study-every", 1, 1000, design_.touchEvery));
        every_->setSuffix(QObject::tr(" servo ticks"));
        return group;
    }

    QWidget* makeStaircase(const std::vector<Scene>& conditions) {
        staircase_ = new StaircaseFields(design_.staircase, conditions);
        connect(staircase_, &StaircaseFields::edited, this, [this] { judge(); });
        return staircase_;
    }

    QWidget* makeQuestions() {
        auto* group = new QGroupBox(QObject::tr("Words"));
        auto* rows = new QVBoxLayout(group);
        const auto add = [&](const QString& words, QPlainTextEdit* edit) {
            auto* label = new QLabel(words);
            label->setBuddy(edit);
            label->setWordWrap(true);
            rows->addWidget(label);
            rows->addWidget(edit);
        };
        add(QObject::tr("Instructions for the participant"),
            instructions_ = text("study-instructions", asIs(design_.instructions), 5));
        QStringList lines;
        for (const StudyQuestion& question : design_.questions)
            lines << lineOf(question);
        add(QObject::tr("Questions after each trial, one a line:\n"
                        "rating | How rough was it? | 7 | smooth | rough\n"
                        "choice | Which hand? | left | right\n"
                        "magnitude | How stiff was it?\n"
                        "text | What was it like?"),
            questions_ = text("study-questions", lines.join(u'\n'), 5));
        rows->addStretch();
        return group;
    }

    QString read() {
        design_.name = name_->text().trimmed().toStdString();
        design_.procedure = Procedure(kind_->currentIndex());
        design_.order = StudyOrder(order_->currentIndex());
        design_.repeats = repeats_->value();
        design_.seed = seed_->text().trimmed().toULongLong();
        design_.prompt = prompt_->text().trimmed().toStdString();
        design_.stimulusSeconds = stimulus_->value();
        design_.pauseSeconds = pause_->value();
        design_.view = StudyView(view_->currentIndex());
        design_.again = again_->isChecked();
        design_.forcesOffBetween = between_->isChecked();
        design_.touchEvery = every_->value();
        design_.instructions = instructions_->toPlainText().trimmed().toStdString();
        design_.staircase = staircase_->rule();
        return readQuestions();
    }

    QString readQuestions() {
        design_.questions.clear();
        for (const QString& line : questions_->toPlainText().split(u'\n', Qt::SkipEmptyParts)) {
            if (line.trimmed().isEmpty()) continue;
            const auto question = questionOf(line);
            if (!question)
                return QObject::tr("questions: \"%1\" begins with no kind; write it as in the examples")
                    .arg(line.trimmed());
            design_.questions.push_back(*question);
        }
        return {};
    }

    /// What was chosen can be kept unless a question cannot be read; the rest the summary tells.
    void judge() {
        if (!questions_) return; // not all is there yet
        const QString fault = read();
        buttons_->button(QDialogButtonBox::Ok)->setEnabled(fault.isEmpty());
        staircase_->setEnabled(design_.procedure == Procedure::Staircase);
        repeats_->setEnabled(design_.procedure != Procedure::Staircase);
        order_->setEnabled(design_.procedure != Procedure::Staircase);
        prompt_->setEnabled(design_.procedure != Procedure::List);
        prompt_->setPlaceholderText(wordsOf(promptOf(design_)));
        summary_->setText(fault.isEmpty() ? summaryOf(design_) : fault);
    }

    QWidget* content_ = nullptr;
    QScrollArea* scrolled_ = nullptr;
    StudyDesign design_;
    QDialogButtonBox* buttons_;
    QLabel* summary_ = nullptr;
    StaircaseFields* staircase_ = nullptr;
    QLineEdit *name_ = nullptr, *seed_ = nullptr, *prompt_ = nullptr;
    QComboBox *kind_ = nullptr, *order_ = nullptr, *view_ = nullptr;
    QSpinBox *repeats_ = nullptr, *every_ = nullptr;
    QDoubleSpinBox *stimulus_ = nullptr, *pause_ = nullptr;
    QCheckBox *again_ = nullptr, *between_ = nullptr;
    QPlainTextEdit *instructions_ = nullptr, *questions_ = nullptr;
};

} // namespace

std::optional<StudyDesign> askForDesign(QWidget* parent, const StudyDesign& now,
                                        const std::vector<Scene>& conditions) {
    DesignDialog dialog(parent, now, conditions);
    if (dialog.exec() != QDialog::Accepted) return {};
    return dialog.design();
}

} // namespace tactum
