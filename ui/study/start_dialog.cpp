#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSpinBox>

#include "ui/study/study_dialog.h"
#include "ui/study/study_panel.h"

namespace tactum {

namespace {

class StartDialog : public QDialog {
public:
    StartDialog(QWidget* parent, const StudyDesign& design, const QString& file)
        : QDialog(parent), design_(design), file_(file.toStdU16String()) {
        setObjectName(QStringLiteral("study-start"));
        setWindowTitle(QObject::tr("Run the study"));
        auto* form = new QFormLayout(this);
        auto* note = new QLabel(QObject::tr("The logs come beside %1.").arg(QFileInfo(file).fileName()));
        note->setTextFormat(Qt::PlainText);
        note->setWordWrap(true);
        participant_ = new QSpinBox;
        participant_->setObjectName(QStringLiteral("study-participant"));
        participant_->setRange(1, 1000000);
        goOn_ = new QCheckBox;
        goOn_->setObjectName(QStringLiteral("study-go-on"));
        auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
        buttons->button(QDialogButtonBox::Ok)->setText(QObject::tr("&Run the study"));
        auto* summary = new QLabel(summaryOf(design));
        summary->setTextFormat(Qt::PlainText);
        form->addRow(QObject::tr("&Participant number"), participant_);
        form->addRow(goOn_);
        form->addRow(summary);
        form->addRow(note);
        form->addRow(buttons);
        connect(participant_, &QSpinBox::valueChanged, this, [this] { look(); });
        connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
        connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
        look();
    }

    StudyStart start() const {
        StudyStart start{file_, participant_->value(), design_.seed,
                         goOn_->isEnabled() && goOn_->isChecked()};
        while (start.seed == 0)
            start.seed = QRandomGenerator::system()->generate64();
        return start;
    }

private:
    void look() {
        const auto broken = brokenOff(design_, file_, participant_->value());
        goOn_->setEnabled(broken.has_value());
        goOn_->setChecked(broken.has_value());
        goOn_->setText(broken ? QObject::tr("&Go on after trial %1, where the last run broke off")
                                    .arg(broken->run.answers.size())
                              : QObject::tr("&Go on: no run of this participant broke off"));
    }

    StudyDesign design_;
    std::filesystem::path file_;
    QSpinBox* participant_;
    QCheckBox* goOn_;
};

} // namespace

std::optional<StudyStart> askForStart(QWidget* parent, const StudyDesign& design, const QString& file) {
    StartDialog dialog(parent, design, file);
    if (dialog.exec() != QDialog::Accepted) return {};
    return dialog.start();
}

} // namespace tactum
