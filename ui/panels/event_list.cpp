#include "ui/panels/event_list.h"

#include <algorithm>

#include <QEvent>

#include "ui/base/style.h"

namespace tactum {

EventList::EventList(QWidget* parent)
    : HintedTree(tr("Nothing has taken the force away so far. What does will be listed here."), parent) {
    setObjectName(QStringLiteral("health-events"));
    setAccessibleName(tr("Last events"));
    setRootIsDecorated(false);
    setWrapping();
    setSelectionMode(QAbstractItemView::NoSelection);
}

void EventList::setEvents(const std::deque<HealthEvent>& events) {
    const auto same = [](const HealthEvent& a, const HealthEvent& b) {
        return a.time == b.time && a.what == b.what;
    };
    if (std::ranges::equal(events, events_, same)) return;
    events_ = events;
    fill();
}

void EventList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) fill();
    HintedTree::changeEvent(event);
}

void EventList::fill() {
    clear();
    for (const HealthEvent& event : events_) {
        auto* item =
            new QTreeWidgetItem(this, {event.time.toString(QStringLiteral("HH:mm:ss  ")) + event.what});
        item->setIcon(0, event.fault ? icon(QStringLiteral("error"), theme().fault)
                                     : icon(QStringLiteral("note"), theme().textDimmed));
        item->setToolTip(0, QStringLiteral("<p>%1</p>").arg(event.sentences.toHtmlEscaped()));
    }
    wrapRows();
}

} // namespace tactum
