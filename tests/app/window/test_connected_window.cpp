// The window at a haptic server: what it does to the scene and the device there is what it does to those at
// home.
//
// What would show that a test here is wrong: the server's side is looked at by itself, the scene in its stage
// and the finger and the force of its device, never by what the window says of them.
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "core/haptics/compile.h"
#include "tests/app/window/connected_window.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_connected_window {

using namespace tactum;
using test::ballScene;
using test::Connected;
using test::Serving;
using test::waitFor;

class TestConnectedWindow : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepareProcess(); }

private slots:
    void initTestCase() { useSettingsIn(settings_.path()); }
    void editsUndoAndRedoAreDoneThere();
    void theMouseLeadsTheHandAndStopEndsTheForceThere();
    void othersAreSeenAndGetTheirTurn();
    void theDockSaysWhereTheDeviceIs();
    void whenTheServerDiesNothingIsLost();

private:
    QTemporaryDir settings_;
};

void TestConnectedWindow::editsUndoAndRedoAreDoneThere() {
    Serving serving;
    serving.begin(ballScene());
    Connected here(serving.place());
    QVERIFY(here.opened());
    QCOMPARE(here.document.scene().objects.at(0).name, std::string("ball"));
    QVERIFY(!here.document.modified());
    QVERIFY(here.window->view().isVisible());
    COMPARE_CONTAINS(here.bar().toStdString(), "you edit");
    here.setStiffness(456);
    QVERIFY(waitFor([&] { return serving.stiffness() == 456; }));
    here.command("undo").trigger();
    QVERIFY(waitFor([&] { return serving.stiffness() == kStiffness.initial; }));
    here.command("redo").trigger();
    QVERIFY(waitFor([&] { return serving.stiffness() == 456; }));
    // Another form of the mesh, and a new object of its own: shapes go over, too.
    here.document.scaleScene(0.5);
    QVERIFY(waitFor([&] {
        const auto scenery = serving.stage->scenery();
        return std::abs(boundsOf(*scenery.scene).diagonal() - boundsOf(here.document.scene()).diagonal()) <
               1e-12;
    }));
    QVERIFY(here.opened());
    here.document.removeObject(here.document.scene().objects.at(0).id);
    QVERIFY(waitFor([&] { return serving.stage->scenery().scene->objects.empty(); }));
    here.command("undo").trigger();
    QVERIFY(waitFor([&] { return serving.stage->scenery().scene->objects.size() == 1; }));
}

void TestConnectedWindow::theMouseLeadsTheHandAndStopEndsTheForceThere() {
    Serving serving;
    serving.begin(ballScene());
    Connected here(serving.place());
    QVERIFY(here.opened());
    QAction& armed = here.command("armed");
    if (!armed.isChecked()) armed.trigger();
    QVERIFY(waitFor([&] { return serving.stage->armed(); }));
    const SceneView& view = here.window->view();
    const QPoint middle = view.mapTo(here.window.get(), view.rect().center());
    QTest::mouseMove(here.window->windowHandle(), middle);
    QTest::mousePress(here.window->windowHandle(), Qt::LeftButton, {}, middle);
    QVERIFY(waitFor([&] {
        if (here.engine.servo().gain < 1 && !armed.isChecked()) armed.trigger(); // a machine that is late
        return here.engine.servo().force.norm() > 0.1;
    }));
    QCOMPARE_GT(here.engine.proxy().output.contacts, 0);
    COMPARE_NEAR(here.engine.proxy().output.proxy.norm(), 0.05 + kProxyRadius.initial, 2e-4,
                 "m"); // on the ball
    const RecordedRun run = serving.stage->recorded();
    QCOMPARE_GT(run.servo.rows.size(), 100u);
    here.command("stop").trigger();
    QVERIFY(waitFor([&] { return !serving.stage->armed(); }));
    QVERIFY(waitFor([&] { return here.engine.servo().force.norm() == 0; }));
    QVERIFY(!armed.isChecked());
    QTest::mouseRelease(here.window->windowHandle(), Qt::LeftButton, {}, middle);
}

void TestConnectedWindow::othersAreSeenAndGetTheirTurn() {
    Serving serving;
    serving.begin(ballScene());
    Connected here(serving.place());
    QVERIFY(here.opened());
    RemoteEngine other({.target = serving.place(), .name = "other"}, nullptr);
    QVERIFY(other.start());
    QVERIFY(waitFor([&] { return here.bar().contains(QStringLiteral("2 clients")); }));
    RemoteEngine third({.target = serving.place(), .name = "third"}, nullptr);
    QVERIFY(third.start());
    third.askForPen();
    auto* asks = here.window->findChild<NoticeBar*>();
    QVERIFY(waitFor([&] { return asks->text().contains(QStringLiteral("third asks")); }));
    QVERIFY(third.stop());
    QVERIFY(waitFor([&] { return asks->text().isEmpty(); })); // nobody waits for an answer
    other.setArmed(false);                                    // which needs no pen
    QVERIFY(waitFor([&] { return asks->text().contains(QStringLiteral("other has stopped all force")); }));
    other.askForPen();
    auto* act = here.window->findChild<QPushButton*>(QStringLiteral("notice-act"));
    QVERIFY(waitFor([&] { return act->isVisible() && act->text() == QStringLiteral("Let them"); }));
    act->click();
    QVERIFY(waitFor([&] { return other.holdsPen(); }));
    QVERIFY(waitFor([&] { return here.bar().contains(QStringLiteral("other edits")); }));
    // What they make arrives as a step of the history.
    std::optional<Scene> theirs;
    QVERIFY(waitFor([&] {
        if (auto arrived = other.arrived()) theirs = arrived->scene;
        return theirs.has_value();
    }));
    theirs->objects.at(0).surfaces.at(0).material.stiffness = 321;
    other.publish(*compile(*theirs));
    QVERIFY(waitFor(
        [&] { return here.document.scene().objects.at(0).surfaces.at(0).material.stiffness == 321; }));
    QCOMPARE(here.document.history().count(), 1);
    COMPARE_CONTAINS(here.document.history().text(0).toStdString(), "other");
    // An edit of one's own is refused now, and said.
    here.setStiffness(600);
    auto* notice = here.window->findChild<NoticeBar*>();
    QVERIFY(waitFor([&] { return notice->text().contains(QStringLiteral("other has the pen")); }));
    QCOMPARE(serving.stiffness(), 321.0);
    const auto shown = [&] { return here.document.scene().objects.at(0).surfaces.at(0).material.stiffness; };
    QVERIFY(waitFor([&] { return shown() == 321; })); // and is not shown either
    QCOMPARE(here.document.history().index(), 1);
    here.command("undo").trigger(); // which is an edit, too
    QVERIFY(waitFor([&] { return shown() == 321 && here.document.history().index() == 1; }));
    QCOMPARE(here.document.history().count(), 2); // the refused edit can be done again
    // Stop needs no pen.
    other.setArmed(true);
    QVERIFY(waitFor([&] { return serving.stage->armed(); }));
    QVERIFY(waitFor([&] { return here.engine.armed(); }));
    here.command("stop").trigger();
    QVERIFY(waitFor([&] { return !serving.stage->armed(); }));
}

void TestConnectedWindow::theDockSaysWhereTheDeviceIs() {
    Serving serving;
    serving.begin(ballScene());
    Connected here(serving.place());
    QVERIFY(here.opened());
    here.command("device-panel").trigger();
    const auto* said = here.window->findChild<QLabel*>(QStringLiteral("device-at-server"));
    QVERIFY(waitFor([&] { return said->isVisible(); }));
    COMPARE_CONTAINS(said->text(), QStringLiteral("Simulated hand is at the haptic server ") +
                                       QString::fromStdString(serving.place()));
    QVERIFY(!here.window->findChild<QWidget*>(QStringLiteral("device-list"))->isVisible());
    COMPARE_CONTAINS(here.command("device-connect").toolTip(), QStringLiteral("at the haptic server"));
    serving.server.reset();
    QVERIFY(waitFor([&] { return said->text().contains(QStringLiteral("is not there")); }));
}

/// Fails each time where the welcome is heard 300 ms late: what the server before had counted makes an empty
/// scene look new.
void TestConnectedWindow::whenTheServerDiesNothingIsLost() {
    Serving serving;
    serving.begin(ballScene());
    const std::uint16_t port = serving.server->port();
    Connected here(serving.place());
    QVERIFY(here.opened());
    here.setStiffness(234);
    QVERIFY(waitFor([&] { return serving.stiffness() == 234; }));
    serving.server.reset();
    QVERIFY(waitFor([&] { return here.bar().contains(QStringLiteral("Not connected")); }));
    QCOMPARE(here.engine.proxy().output.contacts, 0);
    here.setStiffness(345); // goes on
    serving.stage.reset();
    serving.begin({}, port); // a new one, with nothing in it
    QVERIFY(waitFor([&] {
        const auto scenery = serving.stage->scenery();
        return !scenery.scene->objects.empty() && serving.stiffness() == 345;
    }));
    QVERIFY(waitFor([&] { return here.bar().contains(QStringLiteral("you edit")); }));
    QVERIFY(!here.engine.armed());
}

TACTUM_GUI_TEST(TestConnectedWindow)

} // namespace test_connected_window

#include "test_connected_window.moc"
