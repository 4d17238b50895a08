// A haptic server and a window at it, both in the process of a test, over a real socket.
#pragma once

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QTest>

#include "core/protocol/remote_engine.h"
#include "core/protocol/server.h"
#include "device/simulated_hand.h"
#include "tests/support/soups.h"
#include "tests/support/waiting.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/style.h"
#include "ui/document/journal.h"
#include "ui/panels/connection_bar.h"

namespace tactum::test {

/// A ball of 50 mm about the origin.
inline Scene ballScene() {
    Scene scene;
    SceneObject object;
    object.name = "ball";
    object.geometry = ball(0.05, 4);
    object.surfaces.resize(1);
    object.surfaces[0].name = "skin";
    scene.add(object);
    return scene;
}

/// `tactum serve` with a simulated hand, or with two.
struct Serving {
    std::shared_ptr<HandTarget> hand = std::make_shared<HandTarget>();
    std::shared_ptr<HandTarget> second; ///< none: there is one
    std::unique_ptr<Stage> stage;
    std::unique_ptr<Server> server;

    void begin(Scene scene, std::uint16_t port = 0) {
        stage = std::make_unique<Stage>(std::make_unique<SimulatedHand>(hand), hand, std::move(scene));
        if (second)
            if (const auto added = stage->addHand(std::make_unique<SimulatedHand>(second), second); !added)
                qFatal("%s", added.error().text.c_str());
        if (const auto started = stage->start(); !started) qFatal("%s", started.error().text.c_str());
        ServerSettings settings;
        settings.port = port;
        auto made = Server::start(*stage, settings);
        if (!made) qFatal("%s", made.error().text.c_str());
        server = std::move(*made);
    }
    std::string place() const { return "127.0.0.1:" + std::to_string(server->port()); }
    double stiffness() const {
        return stage->scenery().scene->objects.at(0).surfaces.at(0).material.stiffness;
    }
};

/// `tactum --connect`.
struct Connected {
    explicit Connected(const std::string& place) : engine({.target = place}, hand) {
        if (const auto started = engine.start(); !started) qFatal("%s", started.error().text.c_str());
        applyTheme(rememberedTheme());
        window = std::make_unique<MainWindow>(document, engine, hand);
        window->setShared(engine);
        window->resize(1200, 800);
        window->show();
        if (!QTest::qWaitForWindowExposed(window.get(), kPatience)) qFatal("the window does not appear");
        QApplication::setActiveWindow(window.get());
    }
    ~Connected() {
        window->journal().discard();
        window.reset();
    }
    QAction& command(const char* id) {
        for (QMenu* menu : window->findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (action->objectName() == QLatin1String(id)) return *action;
        qFatal("no command %s", id);
        Q_UNREACHABLE();
    }
    bool opened() {
        return waitFor([this] {
            return !document.empty() && window->publisher().world() &&
                   engine.proxy().worldRevision == window->publisher().world()->revision;
        });
    }
    QString bar() const { return window->findChild<ConnectionBar*>()->text(); }
    /// Typed into the inspector.
    void setStiffness(double value) {
        auto* field = window->findChild<QDoubleSpinBox*>(QStringLiteral("stiffness"));
        QTest::mouseClick(field, Qt::LeftButton);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, QString::number(value));
        QTest::keyClick(field, Qt::Key_Return);
    }

    std::shared_ptr<HandTarget> hand = std::make_shared<HandTarget>();
    RemoteEngine engine;
    Document document;
    std::unique_ptr<MainWindow> window;
};

} // namespace tactum::test
