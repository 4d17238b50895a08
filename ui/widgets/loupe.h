// A picture from nearby that lies over the view.
#pragma once

#include <QImage>
#include <QWidget>

namespace tactum {

/// With a line that says how much larger it is. It lets no press through to what it lies over. Thread: ui.
class Loupe : public QWidget {
    Q_OBJECT
public:
    explicit Loupe(QWidget* parent);

    /// `pane`: the name of what is seen from nearby, where there are several; empty: there is one view.
    void setPicture(const QImage& picture, const QString& pane = {});
    const QImage& picture() const { return picture_; }
    /// How many times as large as in the view the picture is.
    void setTimes(double times);

signals:
    /// The pointer is not over it any more.
    void left();
    /// The wheel was turned over it, away from the person by a positive number.
    void turned(double notches);

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void showWords();

    QImage picture_;
    QString pane_;
    double times_ = 1;
};

} // namespace tactum
