// The time of a recording as a line to drag on, with a mark for everything that happened.
#pragma once

#include <vector>

#include <QWidget>

namespace tactum {

/// A place on the line. Faults are drawn as red triangles above it, everything else as ticks.
struct ScrubberMark {
    double time = 0; ///< s since the beginning
    bool fault = false;
    QString text; ///< tooltip
};

/// Click or drag to go to a time; arrow keys go by a hundredth of a second, Page Up and Page Down by one
/// second, Home and End to the ends. Thread: ui.
class Scrubber : public QWidget {
    Q_OBJECT
public:
    explicit Scrubber(QWidget* parent = nullptr);

    void setRecording(double length, std::vector<ScrubberMark> marks);
    /// Shows a time without telling anybody; a hand on the handle knows better.
    void display(double time);
    double time() const { return time_; }
    bool isHeld() const { return held_; }
    QSize sizeHint() const override { return {320, 28}; }
    QSize minimumSizeHint() const override { return {120, 28}; }

signals:
    /// The person wants this time. `resting`: and lets go there.
    void moved(double time, bool resting);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override; ///< tooltips

private:
    QRectF groove() const;
    double xOf(double time) const;
    double timeAt(double x) const;
    void go(double time, bool resting);
    void paintMark(QPainter& painter, const ScrubberMark& mark) const;
    const ScrubberMark* markNear(double x) const;

    double length_ = 0, time_ = 0;
    bool held_ = false;
    std::vector<ScrubberMark> marks_;
};

} // namespace tactum
