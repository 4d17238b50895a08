// The program with two devices at once, a cube under both of them.
#pragma once

#include "tests/ui/window/device_desk.h"

namespace tactum {

inline const QString kOther = QStringLiteral("fake:1-4");
inline constexpr double kTop = 0.05; // m, of the cube

inline std::shared_ptr<FakeDesk> otherArm(bool plugged) {

    auto desk = std::make_shared<FakeDesk>();
    desk->name = "Other arm";
    desk->plugged = plugged;
    desk->place(0.02, kTop + 0.01, 0);
    return desk;
}

/// The program with a cube, the example arm and another one.
struct TwoArms {
    /// `plugged`: the other one, already when the program starts.
    explicit TwoArms(const QTemporaryDir& folder, bool plugged = true) : other(otherArm(plugged)) {
        desk.desk->place(-0.02, kTop + 0.01, 0);
        if (!program().open(writeCube(folder))) qFatal("the cube does not open");
    }
    TouchedWindow& program() { return desk.program; }
    LocalEngine& engine() { return desk.program.engine; }

    void askForOther() {
        other->go = 3;
        desk.chooseRow("Other arm");
        desk.click("device-add-button");
    }
    bool addOther() {
        askForOther();
        return test::waitFor([this] { return engine().hands() == 2 && !desk.link().preparing(); });
    }
    bool bothAreThere() { return desk.connectIt() && addOther(); }
    /// Both press into the top, the second as deep again, until each device gets its force. Where a machine
    /// that is late takes a force away, a person begins anew.
    bool press() {
        return test::waitFor([this] {
            if (!engine().hand(0).armed() || !engine().hand(1).armed()) begin();
            return isForce(*desk.desk, 0, kForce) && isForce(*other, 1, 2 * kForce);
        });
    }
    bool holds(FakeDesk& one, std::size_t hand, double newton) {
        return test::waitFor([&] { return engine().hand(hand).armed() && isForce(one, hand, newton); });
    }
    static constexpr double kForce = 0.4; // N

    std::shared_ptr<FakeDesk> other;
    Desk desk{false, other};

private:
    void begin() {
        desk.desk->y = other->y = kTop + 0.01;
        QAction& armed = program().command("armed");
        if (armed.isChecked()) armed.trigger();
        program().frames(10);
        armed.trigger();
        program().frames(10);
        const double radius = program().document.scene().proxyRadius;
        const double stiffness = program().document.scene().objects[0].surfaces[0].material.stiffness;
        desk.desk->y = kTop + radius - kForce / stiffness;
        other->y = kTop + radius - 2 * kForce / stiffness;
    }
    bool isForce(FakeDesk& one, std::size_t hand, double newton) {
        return std::abs(one.force - newton) < 0.02 * newton &&
               engine().hand(hand).touch().output.contacts == 1;
    }
};

} // namespace tactum
