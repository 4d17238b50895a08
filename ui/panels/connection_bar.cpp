#include "ui/panels/connection_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/base/style.h"
#include "ui/engine/shared_link.h"

namespace tactum {
namespace {

QString wordsFor(const SharedState& state) {
    if (!state.connected) return ConnectionBar::tr("Not connected to %1: no force").arg(state.place);
    const QString pen = state.pen                ? ConnectionBar::tr("you edit")
                        : state.holder.isEmpty() ? ConnectionBar::tr("nobody edits")
                                                 : ConnectionBar::tr("%1 edits").arg(state.holder);
    if (state.attending < 2) return ConnectionBar::tr("Haptic server %1, %2").arg(state.place, pen);
    return ConnectionBar::tr("Haptic server %1, %2 clients, %3")
        .arg(state.place, QString::number(state.attending), pen);
}

} // namespace

ConnectionBar::ConnectionBar(QWidget* parent)
    : QWidget(parent), text_(new QLabel), ask_(new QPushButton(tr("Ask to edit"))) {
    setObjectName(QStringLiteral("connection"));
    setAttribute(Qt::WA_StyledBackground);
    text_->setObjectName(QStringLiteral("connection-text"));
    text_->setTextFormat(Qt::PlainText); // names are others'
    ask_->setObjectName(QStringLiteral("connection-ask"));
    ask_->setToolTip(tr("Asks for the pen, which one client has at a time. Stop needs none"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 12, 4);
    row->setSpacing(kRhythm);
    row->addWidget(text_);
    row->addWidget(ask_);
    connect(ask_, &QPushButton::clicked, this, &ConnectionBar::penWanted);
    hide();
}

void ConnectionBar::display(const SharedState& state) {
    text_->setText(wordsFor(state));
    ask_->setVisible(state.connected && !state.pen);
    setProperty("severity", state.connected ? QStringLiteral("note") : QStringLiteral("error"));
    repolish(*this);
    show();
}

QString ConnectionBar::text() const {
    return text_->text();
}

} // namespace tactum
