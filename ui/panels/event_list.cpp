#include "ui/panels/event_list.h"

#include <QEvent>
#include <QHeaderView>

#include "ui/style.h"

namespace tactum {

EventList::EventList(QWidget* parent)
    : HintedTree(tr("Nothing has taken the force away so far. What does will be listed here."), parent) {
    setObjectName(QStringLiteral("health-events"));
    setAccessibleName(tr("Last events"));
    setRootIsDecorated(false);
    setIconSize({16, 16});
    setColumnCount(2);
    header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(1, QHeaderView::Stretch);
    setSelectionMode(QAbstractItemView::NoSelection);
}

void EventList::setEvents(const std::deque<HealthEvent>& events) {
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
        auto* item = new QTreeWidgetItem(this, {event.time.toString(QStringLiteral("HH:mm:ss")), event.what});
        item->setIcon(0, event.fault ? icon(QStringLiteral("error"), theme().fault)
                                     : icon(QStringLiteral("note"), theme().textDimmed));
        item->setForeground(0, theme().textDimmed);
        for (const int column : {0, 1})
            item->setToolTip(column, QStringLiteral("<p>%1</p>").arg(event.sentences.toHtmlEscaped()));
    }
}

} // namespace tactum
