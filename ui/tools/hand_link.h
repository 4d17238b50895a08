// Between the view, whose mouse leads the finger, and the simulated hand that follows.
#pragma once

#include <memory>

#include <QObject>

#include "core/port/hand_target.h"
#include "core/runtime/hands.h"

namespace tactum {

class SceneView;

/// Thread: ui. Without a target (a real device leads itself) it does nothing.
class HandLink : public QObject {
    Q_OBJECT
public:
    HandLink(SceneView& view, Engine& engine, std::shared_ptr<HandTarget> target, QObject* parent = nullptr);

    /// Puts the finger beside the model, where it is seen, at rest, and the proxy onto it once it is there.
    void placeBeside();
    /// The same at a place.
    void placeAt(const Vec3& p_W);
    /// Once a frame.
    void follow();
    /// While idle a device leads itself, and the mouse has no hand to lead.
    void setIdle(bool idle) { idle_ = idle; }
    bool idle() const { return idle_; }
    /// Which hand of the engine it is that the mouse leads; the first to begin with.
    void setHand(std::size_t hand) { led_ = hand; }
    /// While suspended the hand stays where it is.
    void setSuspended(bool suspended) { suspended_ = suspended; }

private:
    void send();
    void restartOthers();

    SceneView& view_;
    Hands hands_;
    std::size_t led_ = 0;
    std::shared_ptr<HandTarget> target_;
    HandGoal goal_;
    bool suspended_ = false;
    bool idle_ = false;
    std::uint64_t arrival_ = 0; ///< servo tick at which a jump is surely over; 0: none under way
};

} // namespace tactum
