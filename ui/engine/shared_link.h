// Between a scene at a haptic server and the document: what others make of it arrives, and is said.
#pragma once

#include <QObject>
#include <QString>

#include "core/runtime/hands.h"
#include "core/runtime/shared_scene.h"

namespace tactum {

class Document;
class Engine;

/// How the window stands to the server, for the person.
struct SharedState {
    QString place;
    bool connected = false, pen = false;
    QString holder; ///< of the pen; empty: nobody
    QString asker;  ///< who waits for it; empty: nobody
    int attending = 0;
    bool armed = false; ///< whoever has switched the force on

    bool operator==(const SharedState&) const = default;
};

/// Thread: ui.
class SharedLink : public QObject {
    Q_OBJECT
public:
    /// All outlive it; `engine` and `shared` are two sides of one.
    SharedLink(Document& document, Engine& engine, SharedScene& shared, QObject* parent = nullptr);

    /// Once a frame.
    void frame();
    const SharedState& state() const { return state_; }
    void askForPen() { shared_.askForPen(); }
    void givePen(const QString& to) { shared_.givePen(to.toStdString()); }

signals:
    void changed();
    /// One line: why an edit or an order was not done there.
    void refused(const QString& sentence);
    /// One line: somebody else has changed the scene, the connection was made again.
    void told(const QString& sentence);
    /// The server has another scene than the window had: Undo sends the window's own.
    void foundAnother(const QString& sentence);
    void penAskedBy(const QString& name);
    /// Who asked has gone, or has it.
    void penNotAskedAnyMore();

private:
    void take(SharedScene::Arrived arrived);
    void takeBack(const Scene& scene);

    Document& document_;
    const Engine& engine_;
    const Hands hands_;
    SharedScene& shared_;
    SharedState state_;
    bool met_ = false; ///< there was a connection once
};

} // namespace tactum
