// A connected device in the window: its figures and buttons, its workspace, scenes to try it with.
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTest>
#include <cmath>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/device_desk.h"
#include "ui/engine/device_link.h"
#include "ui/engine/device_settings.h"
#include "ui/engine/device_trial.h"
#include "ui/engine/usb_permission.h"
#include "ui/panels/device_panel.h"
#include "ui/study/study_session.h"
#include "ui/view/scene_view.h"

namespace test_device_use {

using namespace tactum;

class TestDeviceUse : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { beginDeviceTest(folder_); }

    void liveFiguresFollowTheDevice();
    void aButtonEndsAllForce();
    void aButtonDoesOneThing();
    void theGripIsChosenAndRemembered();
    void theScaleIsTypedAndRemembered();
    void noImpossibleMappingCanBeChosen();
    void motionsSetTheAxes();
    void reCentringTakesBackWhatTheClutchMoved();
    void beyondTheShellTheWorkspaceGoesOn();
    void howAHandReachesIsOfTheScene();
    void aSceneThatIsTriedBringsItsReach();
    void undoDoesNotTouchTheDevice();
    void trialsAreFeltInsteadOfTheScene();
    void anEditEndsATrial();
    void theSpringDrawsBackToTheCentre();
};

void TestDeviceUse::liveFiguresFollowTheDevice() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Live);
    desk.desk->place(0.012, -0.003, 0.0405);
    QTRY_COMPARE_WITH_TIMEOUT(desk.text("device-position"), QStringLiteral("12.0, -3.0, 40.5 mm"), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("device-rate").endsWith(QStringLiteral("of 1000 Hz")), kPatience);
    QCOMPARE(desk.text("device-heat"), QStringLiteral("0 % warm"));
    const auto heard = [&](const char* name) { return desk.widget(name).accessibleName(); };
    QCOMPARE(heard("device-force"), QStringLiteral("Force 0.00 N of 6.0 N"));
    QTRY_COMPARE_WITH_TIMEOUT(
        heard("workspace-picture"),
        QStringLiteral("Handle at 12, -3, 41 mm in a workspace of 50 mm about the centre"), kPatience);
    QCOMPARE(heard("device-buttons"), QStringLiteral("No button is held"));
    desk.desk->buttons = 0b101;
    QTRY_COMPARE_WITH_TIMEOUT(heard("device-buttons"), QStringLiteral("Held buttons: 1, 3"), kPatience);
}

void TestDeviceUse::aButtonEndsAllForce() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.desk->place(0, 0, 0.08);
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Live);
    desk.pick("device-stop-button", 2);
    desk.click("notice-act");
    QVERIFY(desk.fullForce());
    desk.desk->place(0, 0, 0.0495);
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->force > 0.1, kPatience);
    desk.desk->buttons = 0b101; // others do not
    desk.program.frames(20);
    QCOMPARE_GT(desk.desk->force, 0.1);
    // The servo has taken the force away before the window has seen anything: it does not run here.
    desk.desk->buttons = 0b010;
    desk.engine().poll();
    const std::uint64_t ticks = desk.engine().servo().ticks;
    while (desk.engine().servo().ticks < ticks + 20) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        desk.engine().poll();
    }
    QVERIFY(desk.engine().armed());
    QCOMPARE(desk.desk->force.load(), 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.engine().armed(), kPatience);
    QVERIFY(!desk.program.command("armed").isChecked());
    COMPARE_BEGINS(desk.text("notice-text"), QStringLiteral("Stopped by the button of the device"));
    // It latches: letting go brings nothing back, arming does; not while it is still held.
    desk.desk->buttons = 0;
    desk.program.frames(30);
    QVERIFY(!desk.engine().armed());
    QCOMPARE_EQ(desk.desk->force, 0.0);
    desk.desk->buttons = 0b010;
    desk.program.perform("armed");
    QTRY_VERIFY_WITH_TIMEOUT(!desk.engine().armed(), kPatience);
    QCOMPARE(desk.desk->force.load(), 0.0);
    desk.desk->buttons = 0;
    desk.desk->place(0, 0, 0.08);
    desk.program.frames(10);
    desk.program.perform("armed");
    QVERIFY(desk.fullForce());
    // It is remembered with the device.
    QCOMPARE(rememberedSettings(kFake).stopButton, 0b010u);
}

void TestDeviceUse::aButtonDoesOneThing() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.pick("device-stop-button", 1);
    desk.pick("workspace-clutch", 1);
    QCOMPARE(desk.engine().workspace().clutch, 1u);
    QCOMPARE(desk.link().stop().buttons.load(), 0u);
    desk.pick("device-stop-button", 1);
    QCOMPARE(desk.engine().workspace().clutch, 0u);
    QCOMPARE(desk.link().stop().buttons.load(), 1u);
    QCOMPARE(static_cast<QComboBox&>(desk.widget("workspace-clutch")).currentIndex(), 0);
}

void TestDeviceUse::theGripIsChosenAndRemembered() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Live);
    QVERIFY(!rememberedSettings(kFake).grasped);
    desk.pick("device-grip", 1);
    QTRY_VERIFY_WITH_TIMEOUT((desk.engine().poll(), desk.engine().servo().grasped), kPatience);
    QVERIFY(rememberedSettings(kFake).grasped);
    // The simulated hand keeps none of it.
    desk.program.perform("device-disconnect");
    QTRY_VERIFY_WITH_TIMEOUT((desk.engine().poll(), !desk.engine().servo().grasped), kPatience);
    QVERIFY(!desk.widget("device-grip").isEnabled());
    QVERIFY(desk.connectIt());
    QTRY_VERIFY_WITH_TIMEOUT((desk.engine().poll(), desk.engine().servo().grasped), kPatience);
    desk.pick("device-grip", 0);
    QTRY_VERIFY_WITH_TIMEOUT((desk.engine().poll(), !desk.engine().servo().grasped), kPatience);
}

void TestDeviceUse::theScaleIsTypedAndRemembered() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.program.type(QStringLiteral("workspace-scale"), QStringLiteral("2.5"));
    QCOMPARE(desk.engine().workspace().scale, 2.5);
    desk.desk->place(0.02, 0, 0);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(desk.program.finger().x() - 0.05) < 1e-12, kPatience);
    desk.click("workspace-bump");
    QVERIFY(desk.engine().workspace().bump);
    // The simulated hand keeps none of it.
    desk.program.perform("device-disconnect");
    QCOMPARE(desk.engine().workspace(), Workspace{});
    QVERIFY(!desk.widget("workspace-scale").isVisible());
    QVERIFY(desk.connectIt());
    QCOMPARE(desk.engine().workspace().scale, 2.5);
    QVERIFY(desk.engine().workspace().bump);
    QCOMPARE(desk.program.box(QStringLiteral("workspace-scale")).value(), 2.5);
}

void TestDeviceUse::noImpossibleMappingCanBeChosen() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.pick("workspace-axis-1", 5); // the device's -z
    QCOMPARE(desk.engine().workspace().axes, (AxisMap{-3, 2, 1}));
    QCOMPARE(static_cast<QComboBox&>(desk.widget("workspace-axis-3")).currentIndex(), 0);
    desk.desk->place(0, 0, -0.03);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(desk.program.finger().x() - 0.03) < 1e-12, kPatience);
}

void TestDeviceUse::motionsSetTheAxes() {
    Desk desk;
    QVERIFY(desk.connectIt());
    desk.click("notice-act");
    QVERIFY(desk.engine().armed());
    desk.program.perform("workspace-axes");
    QVERIFY(!desk.engine().armed());
    QVERIFY(!desk.program.command("armed").isChecked()); // nothing pushes now
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("to the right")), kPatience);
    desk.program.frames(10);
    desk.desk->place(0.002, -0.03, 0.003);
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("up")), kPatience);
    desk.program.frames(10);
    desk.desk->place(0.04, 0.03, 0.003); // y is taken: however far it goes, it is not meant
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("toward you")), kPatience);
    QCOMPARE(desk.engine().workspace().axes, kSameAxes);
    desk.program.frames(10);
    desk.desk->place(0, 0, -0.03);
    QTRY_COMPARE_WITH_TIMEOUT(desk.engine().workspace().axes, (AxisMap{-2, 1, -3}), kPatience);
    QVERIFY(!desk.widget("workspace-task").isVisible());
    QCOMPARE(rememberedSettings(kFake).workspace.axes, (AxisMap{-2, 1, -3}));
    // Left in the middle, the axes stay.
    desk.program.perform("workspace-axes");
    desk.program.frames(10);
    desk.desk->place(0.03, 0, -0.03);
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("workspace-task").contains(QStringLiteral("up")), kPatience);
    desk.click("workspace-capture");
    QVERIFY(!desk.widget("workspace-task").isVisible());
    QCOMPARE(desk.engine().workspace().axes, (AxisMap{-2, 1, -3}));
}

void TestDeviceUse::reCentringTakesBackWhatTheClutchMoved() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    QVERIFY(desk.connectIt());
    desk.pick("workspace-clutch", 3);
    const auto offset = [&] { return desk.engine().servo().frame.offset; };
    desk.program.frames(10);
    desk.desk->buttons = 0b100;
    desk.program.frames(10);
    desk.desk->place(0.03, 0, 0);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(offset().x() + 0.03) < 1e-9, kPatience);
    desk.desk->buttons = 0;
    desk.program.frames(10);
    COMPARE_NEAR(offset().x(), -0.03, 1e-9, "m");
    for (int twice = 0; twice < 2; ++twice) {
        desk.program.perform("workspace-centre");
        QTRY_VERIFY_WITH_TIMEOUT(offset().norm() < 1e-9, kPatience);
        desk.desk->buttons = 0b100;
        desk.program.frames(10);
        desk.desk->place(twice ? 0.03 : 0, 0, 0);
        QTRY_VERIFY_WITH_TIMEOUT(offset().norm() > 0.02, kPatience);
        desk.desk->buttons = 0;
        desk.program.frames(10);
    }
    // The cube has a diagonal of 0.1732 m, the arm reaches 0.05 m.
    desk.program.perform("workspace-fit");
    COMPARE_NEAR(desk.engine().workspace().scale, std::sqrt(3.0), 1e-9, "");
}

/// The border is a spring of 200 N/m, and the workspace goes 20 times its stretch a second.
void TestDeviceUse::beyondTheShellTheWorkspaceGoesOn() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.desk->place(0, 0, 0.015);
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.program.type(QStringLiteral("workspace-scale"), QStringLiteral("4")); // outside of the cube
    desk.pick("workspace-reach", 1);
    desk.program.type(QStringLiteral("shell-radius"), QStringLiteral("20"));
    QCOMPARE(desk.engine().workspace().reach, (Reach{ReachMode::Rate, 0.02}));
    const auto offset = [&] { return desk.engine().servo().frame.offset.z(); };
    const auto pulls = [&] { return std::abs(desk.desk->force - 200 * 0.005) < 0.02; };
    // A machine that is late takes the force away, and who is beyond the border when it comes back has it
    // with him: then a person arms anew and pulls once more.
    const auto pull = [&] {
        desk.desk->place(0, 0, 0.015);
        if (!desk.fullForce()) return false;
        for (int i = 0; i <= 40; ++i) {
            desk.desk->place(0, 0, 0.015 + 2.5e-4 * i);
            desk.program.frames(1);
        }
        return test::waitFor([&] { return pulls() || desk.engine().servo().gain < 1; }) && pulls();
    };
    desk.engine().setArmed(true);
    QVERIFY(desk.fullForce());
    QVERIFY(!desk.widget("workspace-beyond").isVisible());
    QCOMPARE(offset(), 0.0);
    bool went = false;
    for (int attempt = 0; attempt < 5 && !went; ++attempt) {
        if (!pull()) continue;
        QVERIFY(desk.widget("workspace-beyond").isVisible());
        const double before = offset(), since = double(desk.engine().servo().ticks);
        desk.program.frames(60);
        if (!pulls()) continue;
        COMPARE_NEAR((offset() - before) / (double(desk.engine().servo().ticks) - since),
                     1e-3 * 4 * 20 * 0.005, 4e-5, "m");
        went = offset() > before + 0.02;
    }
    QVERIFY(went);
    desk.desk->place(0, 0, 0.015);
    QTRY_COMPARE_WITH_TIMEOUT(desk.desk->force.load(), 0.0, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.widget("workspace-beyond").isVisible(), kPatience);
    const double home = offset();
    desk.program.frames(20);
    QCOMPARE(offset(), home);
}

/// Undone with it and kept in its file, and of every hand; none of it is the device's.
void TestDeviceUse::howAHandReachesIsOfTheScene() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.pick("workspace-reach", 2);
    const auto reach = [&] { return desk.engine().workspace().reach; };
    QCOMPARE(reach().mode, ReachMode::Drift);
    QVERIFY(!desk.program.box(QStringLiteral("shell-radius")).isVisible());
    desk.program.perform("undo");
    QCOMPARE(reach(), Reach{});
    QCOMPARE(static_cast<QComboBox&>(desk.widget("workspace-reach")).currentIndex(), 0);
    desk.program.perform("redo");
    QCOMPARE(reach().mode, ReachMode::Drift);
    desk.program.perform("device-disconnect");
    QCOMPARE(reach(), Reach{}); // the mouse leads the simulated hand in the scene itself
    QVERIFY(desk.widget("workspace-reach").isVisible()); // an author needs no device for it
    desk.pick("workspace-reach", 1);
    QCOMPARE(desk.program.document.scene().reach, (Reach{ReachMode::Rate, kUsualShell}));
    QVERIFY(desk.connectIt());
    QCOMPARE(reach().mode, ReachMode::Rate);
}

/// A condition of a study is felt as its author felt it.
void TestDeviceUse::aSceneThatIsTriedBringsItsReach() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    const auto reach = [&] { return desk.engine().workspace().reach; };
    desk.pick("workspace-reach", 2);
    Study study;
    study.design.name = "Reach";
    study.design.conditions = {"drifting"};
    study.conditions = {desk.program.document.scene()};
    desk.program.perform("undo");
    QCOMPARE(reach(), Reach{});
    const QString file = folder_.filePath(QStringLiteral("reach.tactum-study"));
    StudySession& session = desk.program.window->study();
    VERIFY_RESULT(session.begin(std::make_shared<const Study>(study), {file.toStdU16String()}));
    QTRY_COMPARE_WITH_TIMEOUT(reach().mode, ReachMode::Drift, kPatience);
    QCOMPARE(static_cast<QComboBox&>(desk.widget("workspace-reach")).currentIndex(), 0); // the document's
    session.end();
    QTRY_COMPARE_WITH_TIMEOUT(reach(), Reach{}, kPatience);
}

void TestDeviceUse::undoDoesNotTouchTheDevice() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    QVERIFY(desk.connectIt());
    desk.page(DevicePanel::Page::Workspace);
    desk.program.type(QStringLiteral("workspace-scale"), QStringLiteral("3"));
    QVERIFY(!desk.program.document.history().canUndo());
    QVERIFY(!desk.program.document.modified());
    QCOMPARE(desk.engine().workspace().scale, 3.0);
}

void TestDeviceUse::trialsAreFeltInsteadOfTheScene() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    const Scene before = desk.program.document.scene();
    const auto own = desk.program.window->publisher().world();
    QVERIFY(desk.connectIt());
    desk.click("notice-act");
    desk.page(DevicePanel::Page::Trial);
    const auto felt = [&] { return desk.program.window->publisher().world(); };
    const std::pair<const char*, const char*> trials[] = {{"trial-wall-button", "trial-wall"},
                                                          {"trial-friction-button", "trial-friction"},
                                                          {"trial-spring-button", "trial-spring"}};
    for (const auto& [button, id] : trials) {
        desk.click("device-arm");
        desk.click(button);
        QVERIFY(!desk.engine().armed());
        QVERIFY(!desk.program.command("armed").isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp() && felt()->bodies.size() == 1 && felt() != own,
                                 kPatience);
        QCOMPARE_NE(felt()->bodies[0].object, before.objects[0].id);
        QVERIFY(desk.program.command(id).isChecked());
        COMPARE_BEGINS(desk.text("trial-limits"),
                       QStringLiteral("At most 6.0 N, 2.0 N for ever. Stiffness up to"));
        QCOMPARE(desk.program.document.scene(), before);
    }
    // The wall pushes, once the person has armed.
    desk.click("trial-wall-button");
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    desk.desk->place(0.0165, 0, 0);
    desk.program.frames(20);
    QCOMPARE(desk.desk->force.load(), 0.0);
    desk.desk->place(0, 0, 0);
    desk.program.frames(20);
    desk.click("device-arm");
    QVERIFY(desk.fullForce());
    desk.desk->place(0.0165, 0, 0);
    QTRY_VERIFY_WITH_TIMEOUT(desk.desk->force > 0.3, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(desk.text("trial-state").contains(QStringLiteral("on")), kPatience);
    desk.click("trial-end-button");
    QVERIFY(!desk.engine().armed());
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp() && felt()->bodies[0].object == before.objects[0].id,
                             kPatience);
    QVERIFY(felt()->bodies[0].mesh == own->bodies[0].mesh); // nothing was built anew
    QCOMPARE(desk.program.document.scene(), before);
    QVERIFY(!desk.program.document.modified());
    QVERIFY(!desk.program.command("trial-end").isEnabled());
}

void TestDeviceUse::anEditEndsATrial() {
    Desk desk;
    QVERIFY(desk.program.open(writeCube(folder_)));
    desk.program.perform("trial-wall");
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    desk.program.type(QStringLiteral("stiffness"), QStringLiteral("345"));
    QVERIFY(!desk.program.command("trial-wall").isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    const auto& world = *desk.program.window->publisher().world();
    QCOMPARE(world.bodies.at(0).object, desk.program.document.scene().objects[0].id);
    QCOMPARE(world.bodies.at(0).materials.at(0).stiffness, 345.0);
}

void TestDeviceUse::theSpringDrawsBackToTheCentre() {
    Desk desk;
    desk.desk->place(0.03, 0.01, 0);
    QVERIFY(desk.connectIt());
    desk.program.perform("trial-spring");
    QTRY_VERIFY_WITH_TIMEOUT(desk.program.caughtUp(), kPatience);
    desk.program.perform("armed");
    QVERIFY(desk.fullForce());
    // From outside nothing is felt.
    desk.program.frames(20);
    QCOMPARE(desk.desk->force.load(), 0.0);
    for (int i = 30; i >= 0; --i) {
        desk.desk->place(0.001 * i, i / 3000.0, 0);
        desk.program.frames(1);
    }
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(-0.6, 0, 0.8)}) {
        for (int i = 0; i <= 40; ++i) {
            desk.desk->place(1e-3 * i * way.x(), 1e-3 * i * way.y(), 1e-3 * i * way.z());
            desk.program.frames(1);
        }
        // 40 mm of 50 at 6 N times 0.4 / 50 mm: 1.92 N, less what the ball leaves free.
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(desk.desk->force - 1.9) < 0.15, kPatience);
        QCOMPARE_LT(desk.engine().servo().force.dot(way), -1.5);
        for (int i = 40; i >= 0; --i) {
            desk.desk->place(1e-3 * i * way.x(), 1e-3 * i * way.y(), 1e-3 * i * way.z());
            desk.program.frames(1);
        }
    }
}

TACTUM_GUI_TEST(TestDeviceUse)

} // namespace test_device_use

#include "test_device_use.moc"
