#include "ui/panels/compare_panel.h"

#include <algorithm>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/engine/comparison.h"
#include "ui/widgets/compare_chart.h"

namespace tactum {

namespace {

constexpr double kLast = 10; // s

QString pairText(double a, double b, int decimals) {
    return QObject::tr("A %1, B %2").arg(numberText(a, decimals), numberText(b, decimals));
}

bool isLimited(const TouchTrace& rows, double limit) {
    return limit > 0 && std::ranges::any_of(rows, [limit](const TouchRow& row) {
               return row.force.norm() > limit * (1 - 1e-9);
           });
}

} // namespace

ComparePanel::ComparePanel(Comparison& comparison, QWidget* parent)
    : QWidget(parent), comparison_(comparison), automatic_(new QCheckBox(tr("After each edit"))),
      chart_(new CompareChart), figures_(new QLabel) {
    setAttribute(Qt::WA_StyledBackground);
    auto* buttons = new QVBoxLayout;
    buttons->setSpacing(kRhythm / 2);
    auto* whole = new QHBoxLayout(this);
    whole->setContentsMargins(12, kRhythm / 2, 0, kRhythm / 2);
    whole->setSpacing(kRhythm);
    whole->addLayout(buttons);
    record_ = addButton(tr("Record a stroke"), "compare-record",
                        tr("Remembers what the finger does from now on, until it is pressed again"));
    record_->setCheckable(true);
    last_ = addButton(tr("Take the last 10 s"), "compare-last",
                      tr("The stroke is what the finger did in the last ten seconds"));
    mark_ = addButton(tr("Mark as A"), "compare-mark",
                      tr("The scene as it is now is what edits are held against"));
    swap_ = addButton(tr("Swap A and B"), "compare-swap",
                      tr("The scene becomes A again, and A what the scene was; Undo takes it back"));
    export_ = addButton(tr("Export CSV..."), "compare-export", tr("Both forces of each step of the stroke"));
    for (QPushButton* each : {record_, last_, mark_, swap_, export_})
        buttons->addWidget(each);
    automatic_->setObjectName(QStringLiteral("compare-automatic"));
    automatic_->setToolTip(tr("Each edit is compared with A at once"));
    buttons->insertWidget(3, automatic_);
    buttons->addStretch();
    whole->addWidget(chart_, 1);
    figures_->setObjectName(QStringLiteral("compare-figures"));
    figures_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    figures_->setFont(figureFont());
    figures_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    figures_->setMinimumWidth(21 * kRhythm);
    whole->addWidget(figures_);
    connect(record_, &QPushButton::clicked, this, [this](bool on) {
        if (on)
            comparison_.beginStroke();
        else
            comparison_.endStroke();
    });
    connect(last_, &QPushButton::clicked, this, [this] { comparison_.takeLast(kLast); });
    connect(mark_, &QPushButton::clicked, &comparison_, &Comparison::markA);
    connect(swap_, &QPushButton::clicked, &comparison_, &Comparison::swap);
    connect(export_, &QPushButton::clicked, this, &ComparePanel::exportAsked);
    connect(automatic_, &QCheckBox::clicked, &comparison_, &Comparison::setAutomatic);
    connect(&comparison_, &Comparison::changed, this, &ComparePanel::refresh);
    refresh();
}

QPushButton* ComparePanel::addButton(const QString& text, const char* name, const QString& meaning) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(meaning);
    return button;
}

QString ComparePanel::hint() const {
    if (comparison_.recording()) return tr("Stroke the model, then press \"Record a stroke\" again.");
    if (comparison_.stroke().empty())
        return tr("Record a stroke, mark the scene as A, and edit it: the same stroke is felt in both.");
    if (!comparison_.hasA()) return tr("Mark the scene as A, then edit it.");
    return comparison_.working() ? tr("Comparing...") : tr("Edit the scene, or compare after each edit.");
}

void ComparePanel::refresh() {
    record_->setChecked(comparison_.recording());
    record_->setText(comparison_.recording() ? tr("End the stroke") : tr("Record a stroke"));
    swap_->setEnabled(comparison_.hasA());
    automatic_->setChecked(comparison_.automatic());
    const auto& result = comparison_.result();
    export_->setEnabled(result.has_value());
    chart_->setHint(hint());
    chart_->show(result ? result->a : nullptr, result ? result->b : nullptr);
    figures_->setText(figuresOf(comparison_));
    figures_->setVisible(result.has_value());
    figures_->setAccessibleName(tr("Difference: %1").arg(figures_->text()));
}

QString figuresOf(const Comparison& comparison) {
    const auto& result = comparison.result();
    if (!result) return {};
    const TouchDifference& d = result->difference;
    const QString work = QStringLiteral("  ") + pairText(1e3 * d.workA, 1e3 * d.workB, 3);
    const QString ratio = QStringLiteral("  ") + pairText(d.ratioA, d.ratioB, 3);
    QStringList both{QObject::tr("Work, mJ"), work, QObject::tr("Mean friction ratio"), ratio};
    if (isLimited(*result->a, result->limit) || isLimited(*result->b, result->limit))
        both << QObject::tr("Limited to the device's %1 N").arg(numberText(result->limit, 1));
    if (d.largest == 0) return (QStringList(QObject::tr("No difference")) + both).join(u'\n');
    const QStringList lines{
        QObject::tr("Difference B - A"),
        QObject::tr("rms  %1 N").arg(numberText(d.rms, 4)),
        QObject::tr("largest  %1 N").arg(numberText(d.largest, 4)),
        QObject::tr("  at %1 s").arg(numberText(d.largestAt, 3)),
        QObject::tr("  at %1, %2, %3 mm")
            .arg(numberText(1e3 * d.largestWhere.x(), 1), numberText(1e3 * d.largestWhere.y(), 1),
                 numberText(1e3 * d.largestWhere.z(), 1)),
    };
    return (lines + both).join(u'\n');
}

} // namespace tactum
