// The view alone on the whole screen, for others to look at.
#pragma once

#include <QObject>
#include <QTimer>

class QMainWindow;

namespace tactum {

class SceneView;

/// Hides what is around the view, makes its words and the contact larger, and hides a pointer that rests. The
/// window comes back as it was. Panels are the window's own business. Thread: ui.
class Presentation : public QObject {
    Q_OBJECT
public:
    Presentation(QMainWindow& window, SceneView& view);
    ~Presentation() override;

    bool on() const { return on_; }
    void set(bool on);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showPointer();
    void hidePointer();

    QMainWindow& window_;
    SceneView& view_;
    bool on_ = false, pointerHidden_ = false;
    Qt::WindowStates before_;
    QTimer rest_; ///< of the pointer
};

} // namespace tactum
