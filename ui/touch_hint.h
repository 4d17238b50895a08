// The first minute: tells once, over the view, how to touch.
#pragma once

#include <QLabel>

namespace tactum {

/// Lies at the bottom of its parent, lets the mouse through, and never comes back once it was followed.
class TouchHint : public QLabel {
    Q_OBJECT
public:
    explicit TouchHint(QWidget* parent);

    /// Shows the hint, unless it was followed in this or an earlier session.
    void offer();
    /// The person has touched: remembered for good.
    void followed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();
};

} // namespace tactum
