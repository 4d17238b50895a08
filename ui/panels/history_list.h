// The steps of the history: done ones, and dimmed those that were taken back.
#pragma once

#include <QUndoView>

namespace tactum {

/// Thread: ui.
class HistoryList : public QUndoView {
    Q_OBJECT
public:
    explicit HistoryList(QUndoStack& steps, QWidget* parent = nullptr);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override; ///< another theme
};

} // namespace tactum
