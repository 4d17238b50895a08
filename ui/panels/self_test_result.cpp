#include "ui/panels/self_test_result.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/engine/self_test_run.h"

namespace tactum {
namespace {

/// So many digits that say something, without an exponent.
QString shortText(double value, int digits) {
    constexpr double kNothing = 1e-6; // of any unit below
    if (std::abs(value) < kNothing) return QStringLiteral("0");
    const int exponent = QString::number(value, 'e', digits - 1).section(u'e', 1).toInt(); // as it is rounded
    return numberText(value, std::clamp(digits - 1 - exponent, 0, 6));
}

/// In the unit that suits it.
QString figureText(double value, const std::string& unit, int digits = 3) {
    struct Shown {
        double factor;
        QString name;
    };
    const bool micro = unit == "m" && std::abs(value) < 1e-4;
    const Shown shown = micro          ? Shown{1e6, QStringLiteral("µm")}
                        : unit == "m"  ? Shown{1e3, QStringLiteral("mm")}
                        : unit == "s"  ? Shown{1e3, QStringLiteral("ms")}
                        : unit == "kg" ? Shown{1e3, QStringLiteral("g")}
                                       : Shown{1, wordsOf(std::string_view(unit))};
    return (shortText(shown.factor * value, digits) + u' ' + shown.name).trimmed();
}

QString listOf(const std::vector<TrialWords>& lines) {
    QString text;
    for (const TrialWords& line : lines)
        text += QStringLiteral("<li>%1</li>").arg(trialText(line).toHtmlEscaped());
    return QStringLiteral("<ul style='margin:0; margin-left:16px; -qt-list-indent:0'>%1</ul>").arg(text);
}

QLabel* selectable(const char* name) {
    auto* made = new QLabel;
    made->setObjectName(QLatin1String(name));
    made->setWordWrap(true);
    made->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return made;
}

} // namespace

SelfTestResult::SelfTestResult(QWidget* parent)
    : QWidget(parent), verdict_(selectable("self-test-verdict")), found_(selectable("self-test-found")),
      told_(selectable("self-test-told")), figures_(new QTreeWidget) {
    verdict_->setProperty("heading", true);
    figures_->setObjectName(QStringLiteral("self-test-figures"));
    figures_->setAccessibleName(tr("What was measured"));
    figures_->setHeaderLabels({tr("Figure"), tr("Value"), tr("Error"), tr("Said before")});
    figures_->setRootIsDecorated(false);
    figures_->setAlternatingRowColors(true);
    auto* scroll = new QScrollArea;
    scroll->setWidget(found_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    found_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(kRhythm);
    column->addWidget(verdict_);
    column->addWidget(scroll, 2);
    column->addWidget(figures_, 3);
    column->addWidget(told_);
    column->addWidget(makeButtons());
}

QWidget* SelfTestResult::makeButtons() {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins({});
    const auto button = [&](const QString& text, const char* name, void (SelfTestResult::*pressed)()) {
        auto* made = new QPushButton(text);
        made->setObjectName(QLatin1String(name));
        connect(made, &QPushButton::clicked, this, pressed);
        line->addWidget(made);
        return made;
    };
    button(tr("Show &report"), "self-test-report", &SelfTestResult::showPressed);
    button(tr("Save &as..."), "self-test-save", &SelfTestResult::savePressed);
    line->addStretch();
    button(tr("Close"), "self-test-close", &SelfTestResult::closePressed);
    keep_ = button(tr("&Use this profile"), "self-test-keep", &SelfTestResult::keepPressed);
    keep_->setProperty("primary", true);
    return row;
}

void SelfTestResult::show(const SelfTestReport& report) {
    verdict_->setText(report.faults.empty() ? tr("Nothing wrong was found.") : tr("This is wrong:"));
    QString found = report.faults.empty() ? QString() : listOf(report.faults);
    if (!report.leftOut.empty())
        found += QStringLiteral("<p>%1</p>%2").arg(tr("Left out:").toHtmlEscaped(), listOf(report.leftOut));
    found_->setText(found);
    figures_->clear();
    for (const SelfTestFigure& figure : report.figures) {
        const double error = figure.measured.error;
        new QTreeWidgetItem(
            figures_, {trialText(figure.name), figureText(figure.measured.value, figure.unit),
                       error > 0 ? QStringLiteral("± %1").arg(figureText(error, figure.unit, 2)) : QString(),
                       figure.said ? figureText(*figure.said, figure.unit) : QString()});
    }
    for (int column = 0; column < figures_->columnCount(); ++column)
        figures_->resizeColumnToContents(column);
    const bool any = std::ranges::any_of(report.figures, [](const auto& each) { return !each.key.empty(); });
    keep_->setEnabled(any);
    keep_->setToolTip(any ? tr("The figures are laid over the device's profile, and hold from now on")
                          : tr("No figure was measured that a profile has."));
    keep_->setFocus();
}

void SelfTestResult::tell(const QString& words, bool wrong) {
    told_->setProperty("limit", wrong);
    repolish(*told_);
    told_->setText(words);
    if (!wrong) keep_->setAccessibleDescription(words);
}

} // namespace tactum
