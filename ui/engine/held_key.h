// Notices a key that is held down, wherever the focus is.
#pragma once

#include <QObject>
#include <QTimer>

namespace tactum {

/// Emits held() once when `key` has been down for `milliseconds`; a release that waited meanwhile, because
/// the window was busy, counts. Never swallows the key. Thread: ui.
class HeldKey : public QObject {
    Q_OBJECT
public:
    HeldKey(Qt::Key key, int milliseconds, QObject* parent = nullptr);

signals:
    void held();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void stop();

    Qt::Key key_;
    QTimer timer_;      ///< to shortly before the end,
    QTimer last_;       ///< and the rest, in which events are heard that a busy window has not got yet
    bool lost_ = false; ///< its release may have gone with a dialog or a menu
};

} // namespace tactum
