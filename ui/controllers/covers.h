// What lies over the view, for those who write into it.
#pragma once

#include <QObject>

class QWidget;

namespace tactum {

class SceneView;

/// Tells the view which of its parts rows of tools, notices and bars hide. Thread: ui.
class Covers : public QObject {
    Q_OBJECT
public:
    /// `body`: the parent of all that lies over the view.
    Covers(QWidget& body, SceneView& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QList<QWidget*> over() const;
    void tell();

    QWidget& body_;
    SceneView& view_;
};

} // namespace tactum
