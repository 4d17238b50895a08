// What is in the centre of the window: the start page, the document's scene, or another in its place.
#pragma once

#include <functional>

#include <QObject>

class QStackedWidget;
class QWidget;

namespace tactum {

class Document;
class SceneView;
struct Scene;

/// Shared by the controllers. Thread: ui.
class Stage : public QObject {
    Q_OBJECT
public:
    Stage(Document& document, SceneView& view, QStackedWidget& centre, QWidget& start, QObject* parent);

    /// Asked whenever the document's place is shown: a window whose server is not there has no start page,
    /// for what that would open nobody could feel.
    void setApart(std::function<bool()> apart) { apart_ = std::move(apart); }

    /// The start page where there is nothing yet, else the view.
    void showCentre();
    /// The view, for something else than the document's scene.
    void showView();
    /// Another scene in the document's place, all of it seen; whoever shows it places the hand.
    void showOther(const Scene& scene);
    /// The document's scene again, likewise.
    void showOwn();

signals:
    void otherShown();

private:
    Document& document_;
    SceneView& view_;
    QStackedWidget& centre_;
    QWidget& start_;
    std::function<bool()> apart_;
};

} // namespace tactum
