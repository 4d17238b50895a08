#include "ui/panels/recovery_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "ui/base/style.h"
#include "ui/document/recovery.h"

namespace tactum {

namespace {

QPushButton* button(const QString& text, const char* name, std::size_t index) {
    auto* made = new QPushButton(text);
    made->setObjectName(QStringLiteral("%1-%2").arg(QLatin1String(name)).arg(index));
    return made;
}

} // namespace

RecoveryBar::RecoveryBar(Recovery& recovery, QWidget* parent)
    : QWidget(parent), recovery_(recovery), lines_(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("recovery"));
    setAccessibleName(tr("Scenes that were not saved"));
    lines_->setContentsMargins(0, 0, 0, 0);
    lines_->setSpacing(0);
    connect(&recovery_, &Recovery::changed, this, &RecoveryBar::refresh);
    hide();
}

void RecoveryBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

void RecoveryBar::refresh() {
    // Not at once: one of their buttons may be what was pressed.
    for (auto* line : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        lines_->removeWidget(line);
        line->hide();
        line->setObjectName({});
        for (auto* part : line->findChildren<QWidget*>())
            part->setObjectName({});
        line->deleteLater();
    }
    for (std::size_t i = 0; i < recovery_.scenes().size(); ++i)
        lines_->addWidget(makeLine(i));
    setVisible(!later_ && !recovery_.scenes().empty());
}

QWidget* RecoveryBar::makeLine(std::size_t index) {
    const LostScene& scene = recovery_.scenes()[index];
    auto* line = new QWidget;
    line->setProperty("recoveryLine", true);
    line->setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(12, 6, kRhythm, 6);
    row->setSpacing(kRhythm);
    auto* sign = new QLabel;
    sign->setPixmap(icon(QStringLiteral("recent"), theme().accent).pixmap(16, 16));
    auto* text =
        new QLabel(scene.thrownAway ? tr("%1 was thrown away.").arg(QString::fromStdString(scene.entry.title))
                                    : sentenceOf(scene));
    text->setObjectName(QStringLiteral("recovery-text-%1").arg(index));
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // the name of a file is one long word
    text->setToolTip(QString::fromStdU16String(scene.entry.file.u16string()));
    row->addWidget(sign);
    row->addWidget(text, 1);
    addChoices(*line, index);
    return line;
}

void RecoveryBar::addChoices(QWidget& line, std::size_t index) {
    const LostScene& scene = recovery_.scenes()[index];
    const QString title = QString::fromStdString(scene.entry.title);
    auto* row = static_cast<QHBoxLayout*>(line.layout());
    if (scene.thrownAway) {
        auto* back = button(tr("Bring it back"), "recovery-back", index);
        back->setAccessibleName(tr("Bring %1 back").arg(title));
        connect(back, &QPushButton::clicked, this, [this, index] { recovery_.bringBack(index); });
        row->addWidget(back);
    } else {
        auto* recover = button(tr("Recover"), "recovery-recover", index);
        recover->setProperty("primary", true);
        recover->setAccessibleName(tr("Recover %1").arg(title));
        recover->setToolTip(tr("Opens it as it was, with unsaved changes; its file stays as it is"));
        connect(recover, &QPushButton::clicked, this, [this, index] { emit recoverAsked(index); });
        auto* away = button(tr("Throw away"), "recovery-throw", index);
        away->setAccessibleName(tr("Throw %1 away").arg(title));
        away->setToolTip(tr("Deleted when the program ends; until then it can be brought back"));
        connect(away, &QPushButton::clicked, this, [this, index] { recovery_.throwAway(index); });
        row->addWidget(recover);
        row->addWidget(away);
    }
    auto* later = new QToolButton;
    later->setObjectName(QStringLiteral("recovery-later"));
    later->setIcon(icon(QStringLiteral("close")));
    later->setIconSize({16, 16});
    later->setAccessibleName(tr("Ask again at the next start"));
    later->setToolTip(later->accessibleName());
    connect(later, &QToolButton::clicked, this, [this] {
        later_ = true;
        hide();
    });
    row->addWidget(later);
    auto policy = later->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // one is enough; the others keep its room
    later->setSizePolicy(policy);
    later->setVisible(index == 0);
}

} // namespace tactum
