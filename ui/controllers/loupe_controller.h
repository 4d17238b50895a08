// The loupe over the view: when it is there, where it lies, and how much larger it shows the contact.
#pragma once

#include <QObject>
#include <QRect>

#include "ui/controllers/workbench.h"

namespace tactum {

class Loupe;

/// Made when there is something to show first. It lies at the right of the view, above what lies at the foot
/// or beneath the axes, away from the contact; not at all where the view is too low for two. Thread: ui.
class LoupeController : public QObject {
    Q_OBJECT
public:
    static constexpr double kLeastTimes = 3, kMostTimes = 10;

    explicit LoupeController(const Workbench& bench);

private:
    void show(const QImage& picture, QPointF contact, const QString& pane);
    void place(QPointF contact);
    /// From the axes to the foot, as far as nothing lies there; in the view.
    QRect column(int side) const;
    void turn(double notches);
    void useLook();

    Workbench bench_;
    QWidget& body_; ///< the parent of all that lies over the view
    Loupe* loupe_ = nullptr;
    double times_;
    int side_;
    bool low_ = true;   ///< in the lower corner
    bool open_ = false; ///< something is touched, or was just now
};

} // namespace tactum
