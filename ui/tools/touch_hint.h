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
    /// Above whatever lies over the lower edge of the view, so many pixels high.
    void keepAbove(int height);
    /// The person has touched: remembered for good.
    void followed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    int below_ = 0; ///< pixels
};

} // namespace tactum
