// The hands of a server in the window: each is seen and felt, and the window drives all of them.
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "tests/app/window/connected_window.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/drawn_hand.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace test_connected_hands {

using namespace tactum;
using test::ballScene;
using test::Connected;
using test::Serving;
using test::waitFor;

class TestConnectedHands : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepareProcess(); }

private slots:
    void initTestCase() {
        useSettingsIn(settings_.path());
        unfoldPlots();
    }
    void everyHandIsThere();
    void handsComeAndGoWithTheServer();
    void aProcessWithTwoDevicesIsFelt();

private:
    QTemporaryDir settings_;
};

/// Two hands, of which the second is led beside the window.
void TestConnectedHands::everyHandIsThere() {
    Serving serving;
    serving.second = std::make_shared<HandTarget>();
    serving.begin(ballScene());
    Connected here(serving.place());
    QVERIFY(here.opened());
    auto* rows = here.window->findChild<QWidget*>(QStringLiteral("hand-list"));
    const auto row = [&](const char* name) {
        return here.window->findChild<QToolButton*>(QLatin1String(name));
    };
    here.command("device-panel").trigger();
    QVERIFY(waitFor([&] { return rows->isVisible() && row("hand-1") && row("hand-1")->isVisible(); }));
    QVERIFY(row("hand-0")->isChecked());
    // They are of one name, so that each has its number.
    for (const int hand : {0, 1})
        COMPARE_BEGINS(row(hand == 0 ? "hand-0" : "hand-1")->text(),
                       QStringLiteral("Simulated hand %1 \u00b7 ").arg(hand + 1));
    QVERIFY(!row("hand-remove-1")->isVisible()); // it is the server's
    QAction& armed = here.command("armed");
    if (!armed.isChecked()) armed.trigger();
    const auto gain = [&](std::size_t hand) {
        if (!armed.isChecked()) armed.trigger(); // a machine that is late
        return here.engine.told(hand).servo.gain;
    };
    QVERIFY(waitFor([&] { return gain(0) == 1 && gain(1) == 1; }));
    QVERIFY(waitFor([&] { return row("hand-1")->text().endsWith(QStringLiteral("forces on")); }));
    // The second hand presses from above, and is seen; the first, which is chosen, feels nothing.
    serving.second->write({.position = {0, 0.08, 0}, .teleport = true, .sequence = 7});
    QVERIFY(waitFor([&] { return std::abs(here.engine.told(1).servo.finger.y() - 0.08) < 1e-3; }));
    here.engine.restartProxyOf(1);
    serving.second->write({.position = {0, 0.045, 0}, .sequence = 7, .time = 0.3});
    QVERIFY(waitFor([&] {
        (void)gain(1);
        return here.engine.told(1).servo.force.y() > 0.5;
    }));
    COMPARE_NEAR(here.engine.told(1).touch.output.proxy.norm(), 0.05 + kProxyRadius.initial, 2e-4, "m");
    QCOMPARE(here.engine.servo().force.norm(), 0.0);
    SceneView& view = here.window->view();
    QVERIFY(waitFor([&] { return isDrawn(view, 1); }));
    // Chosen, it has the status and the plots.
    QTest::mouseClick(row("hand-1"), Qt::LeftButton);
    QVERIFY(waitFor([&] { return here.engine.servo().force.y() > 0.5; }));
    const auto* plot = here.window->findChild<ForcePlot*>();
    QVERIFY(waitFor([&] {
        const auto& samples = plot->history().samples();
        return !samples.empty() && samples.back().touching && samples.back().magnitude > 0.5;
    }));
    QVERIFY(!here.command("hand-remove").isEnabled());
    QCOMPARE(here.command("hand-remove").toolTip(), QStringLiteral("The hands are the server's."));
    // The mouse leads the first still.
    const QPoint middle = view.mapTo(here.window.get(), view.rect().center());
    QTest::mousePress(here.window->windowHandle(), Qt::LeftButton, {}, middle);
    QVERIFY(waitFor([&] {
        (void)gain(0);
        return here.engine.told(0).servo.force.norm() > 0.1;
    }));
    const RecordedRun run = here.engine.recorded();
    QCOMPARE(run.hands(), std::size_t(2));
    here.command("stop").trigger();
    QVERIFY(waitFor([&] {
        return here.engine.told(0).servo.force.norm() == 0 && here.engine.told(1).servo.force.norm() == 0;
    }));
    QVERIFY(!serving.stage->armed());
    QTest::mouseRelease(here.window->windowHandle(), Qt::LeftButton, {}, middle);
}

void TestConnectedHands::handsComeAndGoWithTheServer() {
    Serving serving;
    serving.begin(ballScene());
    const std::uint16_t port = serving.server->port();
    Connected here(serving.place());
    QVERIFY(here.opened());
    here.command("device-panel").trigger();
    const auto* rows = here.window->findChild<QWidget*>(QStringLiteral("hand-list"));
    const auto another = [&](bool withSecond) {
        serving.server.reset();
        serving.stage.reset();
        if (!waitFor([&] { return !here.engine.running(); })) return false;
        serving.second = withSecond ? std::make_shared<HandTarget>() : nullptr;
        serving.begin(ballScene(), port);
        return waitFor([&] { return here.engine.running() && rows->isVisible() == withSecond; });
    };
    QVERIFY(!rows->isVisible());
    QVERIFY(another(true));
    here.command("hand-next").trigger();
    QCOMPARE(here.engine.spokenOf(), std::size_t(1));
    QVERIFY(another(false));
    QCOMPARE(here.engine.spokenOf(), std::size_t(0));
    QVERIFY(!here.command("hand-next").isEnabled());
}

/// As a person starts it.
void TestConnectedHands::aProcessWithTwoDevicesIsFelt() {
    QTemporaryDir folder;
    QProcess server;
    server.start(QStringLiteral(TACTUM_PROGRAM),
                 {"serve", writeCube(folder), "--device", "simulated", "--device", "simulated", "--listen",
                  "127.0.0.1:0", "--until-input-ends"});
    QVERIFY(server.waitForStarted(60000));
    while (!server.canReadLine())
        QVERIFY(server.waitForReadyRead(60000));
    const QString line = QString::fromUtf8(server.readLine()).trimmed();
    Connected here(line.section(u' ', -1).toStdString());
    QVERIFY(here.opened());
    QCOMPARE(here.engine.hands(), std::size_t(2));
    QAction& armed = here.command("armed");
    const auto bothArmed = [&] { return here.engine.told(0).armed && here.engine.told(1).armed; };
    if (!bothArmed()) armed.trigger();
    QVERIFY(waitFor(bothArmed));
    const SceneView& view = here.window->view();
    const QPoint middle = view.mapTo(here.window.get(), view.rect().center());
    QTest::mouseMove(here.window->windowHandle(), middle);
    QTest::mousePress(here.window->windowHandle(), Qt::LeftButton, {}, middle);
    QVERIFY(waitFor([&] {
        if (!armed.isChecked()) armed.trigger(); // a machine that is late
        return here.engine.told(0).servo.force.norm() > 0.1;
    }));
    QCOMPARE(here.engine.told(1).servo.force.norm(), 0.0);
    here.command("hand-next").trigger();
    QCOMPARE(here.engine.spokenOf(), std::size_t(1));
    here.command("stop").trigger();
    QVERIFY(
        waitFor([&] { return here.engine.told(0).servo.force.norm() == 0 && !here.engine.told(1).armed; }));
    QTest::mouseRelease(here.window->windowHandle(), Qt::LeftButton, {}, middle);
    server.closeWriteChannel();
    QVERIFY(server.waitForFinished(60000));
    QCOMPARE(server.exitCode(), 0);
    QVERIFY(waitFor([&] { return !here.engine.running(); }));
}

TACTUM_GUI_TEST(TestConnectedHands)

} // namespace test_connected_hands

#include "test_connected_hands.moc"
