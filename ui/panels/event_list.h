// The last times that something took force or fidelity away.
#pragma once

#include <deque>

#include "ui/engine/guard_watch.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

class EventList : public HintedTree {
    Q_OBJECT
public:
    explicit EventList(QWidget* parent = nullptr);

    void setEvents(const std::deque<HealthEvent>& events);
    QSize sizeHint() const override { return {200, 96}; } ///< takes what is left, asks for little

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void fill();

    std::deque<HealthEvent> events_;
};

} // namespace tactum
