// What the charts in widgets have in common.
#pragma once

#include <QWidget>

#include "ui/base/style.h"

namespace tactum {

/// Fills its background, sets the font of figures, and draws what its heirs have, or a sentence where they
/// have nothing. Thread: ui.
class Chart : public QWidget {
    Q_OBJECT
public:
    /// In the place of what there is not: why, and how to get it.
    void setHint(const QString& hint);
    const QString& hint() const { return hint_; }

protected:
    /// `name`: of the object; `said`: for who does not see it; `about`: the room for figures about the area.
    Chart(const QString& name, const QString& said, const QMargins& about, QWidget* parent);

    void paintEvent(QPaintEvent* event) final;
    /// Where the curves are.
    QRectF area() const { return QRectF(rect().marginsRemoved(about_)); }
    virtual QColor background() const { return theme().panel; }
    virtual bool any() const { return true; }
    virtual void paintChart(QPainter& painter) const = 0;

private:
    QMargins about_;
    QString hint_;
};

} // namespace tactum
