// The pages of the dock of devices, each for itself: what they show of a state, and what they ask for.
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "core/port/hand_target.h"
#include "core/runtime/local_engine.h"
#include "device/simulated_hand.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/engine/device_link.h"
#include "ui/panels/device_connect.h"
#include "ui/panels/device_live.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/device_steps.h"
#include "ui/panels/device_trial_page.h"
#include "ui/panels/workspace_fields.h"
#include "ui/widgets/number_box.h"

namespace test_device_pages {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// Devices of every kind of row; none is ever made.
class Shelf final : public DeviceCatalogue {
public:
    std::vector<DeviceListing> list() override {
        return {{"simulated", "Simulated hand", true, "The mouse leads it."},
                {"arm", "Example arm", true, "6 N"},
                {"old", "Old arm", false, "Its library is missing.", true, "firmware (*.bin)"},
                {"", "A remark", false, "Something is plugged in."}};
    }
    Result<std::unique_ptr<HapticDevice>> make(const std::string& id) override {
        if (id == "simulated") return std::make_unique<SimulatedHand>(std::make_shared<HandTarget>());
        return machineError("It does not answer: switch it on.");
    }
    Result<std::string> supply(const std::string&, const std::filesystem::path&) override { return "taken"; }
    Result<std::string> keepFigures(const std::string&, const std::string&) override { return "kept"; }
};

struct Loops {
    LocalEngine engine{std::make_unique<SimulatedHand>(std::make_shared<HandTarget>())};
};

} // namespace

class TestDevicePages : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumDevicePages"); }

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }
    void init() { QSettings().clear(); }
    void cleanup() { QSettings().clear(); }

    void theStepsOfADevice() {
        using State = Preparation::State;
        DeviceSteps steps;
        Preparation now;
        steps.show(now);
        COMPARE_SHOWN(shownIn(steps), "steps-none");
        now = {State::Running,
               false,
               QStringLiteral("arm"),
               QStringLiteral("Arm"),
               {{QStringLiteral("Load"), StepState::Done},
                {QStringLiteral("Home"), StepState::Doing},
                {QStringLiteral("Rest"), StepState::Waiting}},
               QStringLiteral("Lift the handle."),
               0.25,
               false,
               {}};
        steps.show(now);
        COMPARE_SHOWN(shownIn(steps), "steps-running");
        QSignalSpy gaveUp(&steps, &DeviceSteps::giveUpPressed), again(&steps, &DeviceSteps::againPressed);
        part<QPushButton>(steps, "device-give-up").click();
        QCOMPARE(gaveUp.size(), 1);
        now.givingUp = true;
        now.request.clear();
        steps.show(now);
        COMPARE_SHOWN(shownIn(steps), "steps-giving-up");
        now.givingUp = false;
        now.state = State::GivenUp;
        now.steps.clear();
        steps.show(now);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        COMPARE_SHOWN(shownIn(steps), "steps-given-up");
        now.state = State::Failed;
        now.steps = {{QStringLiteral("Load"), StepState::Failed}};
        now.failure = QStringLiteral("It does not answer.");
        now.request = QStringLiteral("Lift the handle."); // nothing is to be done any more
        steps.show(now);
        COMPARE_SHOWN(shownIn(steps), "steps-failed");
        part<QPushButton>(steps, "device-again").click();
        QCOMPARE(again.size(), 1);
        now.state = State::Done;
        steps.show(now);
        QVERIFY(steps.isHidden());
    }

    void theLivePage() {
        Loops loops;
        DeviceLive page;
        COMPARE_SHOWN(shownIn(page), "live-none");
        page.display(loops.engine);
        page.setStopButton(0b10, 3, true);
        page.setGrasped(true, true);
        COMPARE_SHOWN(shownIn(page), "live");
        QSignalSpy chosen(&page, &DeviceLive::stopButtonChosen);
        auto& list = part<QComboBox>(page, "device-stop-button");
        for (int row = 0; row < 4; ++row)
            emit list.activated(row);
        QCOMPARE(chosen.size(), 4);
        for (int row = 0; row < 4; ++row)
            QCOMPARE(chosen[row][0].toUInt(), row == 0 ? 0u : 1u << (row - 1));
        QSignalSpy grip(&page, &DeviceLive::graspChosen);
        emit part<QComboBox>(page, "device-grip").activated(0);
        emit part<QComboBox>(page, "device-grip").activated(1);
        QCOMPARE(grip.size(), 2);
        QVERIFY(!grip[0][0].toBool() && grip[1][0].toBool());
        page.setGrasped(false, true);
        page.setStopButton(0, 0, true);
        COMPARE_SHOWN(shownIn(page), "live-no-button");
        page.setStopButton(0, 2, false);
        page.setGrasped(false, false);
        COMPARE_SHOWN(shownIn(page), "live-simulated");
        QCOMPARE(chosen.size(), 4); // shown without telling anybody
    }

    /// Every sixth frame: more often nobody reads them.
    void figuresRestForAWhile() {
        Loops loops;
        DeviceLive page;
        page.display(loops.engine);
        auto& rate = part<QLabel>(page, "device-rate");
        QVERIFY(!rate.text().isEmpty());
        for (int round = 0; round < 3; ++round) {
            rate.clear();
            for (int frame = 0; frame < 5; ++frame) {
                page.display(loops.engine);
                QCOMPARE(rate.text(), "");
            }
            page.display(loops.engine);
            QVERIFY(!rate.text().isEmpty());
        }
    }

    void theTrialPage() {
        Loops loops;
        DeviceTrialPage page;
        COMPARE_SHOWN(shownIn(page), "trial-none");
        page.setTrial(Trial::Wall);
        page.display(loops.engine);
        COMPARE_SHOWN(shownIn(page), "trial-wall");
        std::vector<Trial> chosen;
        connect(&page, &DeviceTrialPage::chosen, &page, [&](Trial trial) { chosen.push_back(trial); });
        QSignalSpy ended(&page, &DeviceTrialPage::endPressed);
        part<QToolButton>(page, "trial-spring-button").click();
        part<QToolButton>(page, "trial-friction-button").click();
        QCOMPARE(chosen, (std::vector{Trial::Spring, Trial::Friction}));
        QVERIFY(part<QToolButton>(page, "trial-wall-button").isChecked()); // until whoever decides says so
        QVERIFY(!part<QToolButton>(page, "trial-spring-button").isChecked());
        part<QPushButton>(page, "trial-end-button").click();
        QCOMPARE(ended.size(), 1);
        auto& state = part<QLabel>(page, "trial-state");
        page.display(loops.engine);
        state.clear();
        for (int frame = 0; frame < 5; ++frame)
            page.display(loops.engine);
        QCOMPARE(state.text(), "");
        page.display(loops.engine);
        QCOMPARE(state.text(), "The forces are off. Hold the handle, then arm.");
        state.clear();
        page.setTrial({}); // another trial is shown at once
        page.display(loops.engine);
        QVERIFY(!state.text().isEmpty());
        COMPARE_SHOWN(shownIn(page), "trial-ended");
    }

    void theWorkspacePage() {
        WorkspaceFields page;
        COMPARE_SHOWN(shownIn(page), "workspace-simulated");
        Workspace workspace;
        workspace.scale = 2;
        workspace.axes = {3, -1, 2};
        workspace.clutch = 0b100;
        workspace.bump = true;
        page.show(workspace, 3, 0.05, true);
        COMPARE_SHOWN(shownIn(page), "workspace");
        std::vector<Workspace> edited;
        connect(&page, &WorkspaceFields::edited, &page, [&](const Workspace& now) { edited.push_back(now); });
        QSignalSpy centred(&page, &WorkspaceFields::centrePressed),
            fitted(&page, &WorkspaceFields::fitPressed);
        part<QPushButton>(page, "workspace-centre-button").click();
        part<QPushButton>(page, "workspace-fit-button").click();
        QCOMPARE(centred.size(), 1);
        QCOMPARE(fitted.size(), 1);
        QVERIFY(edited.empty());
        // Each edit changes one thing and leaves the others.
        const auto other = [&](auto change) {
            change(workspace);
            return workspace;
        };
        auto& scale = part<NumberBox>(page, "workspace-scale");
        scale.setValue(3);
        QCOMPARE(edited.back(), other([](Workspace& w) { w.scale = 3; }));
        auto& clutch = part<QComboBox>(page, "workspace-clutch");
        emit clutch.activated(1);
        QCOMPARE(edited.back(), other([](Workspace& w) { w.clutch = 1; }));
        emit clutch.activated(2);
        QCOMPARE(edited.back(), other([](Workspace& w) { w.clutch = 2; }));
        emit clutch.activated(0);
        QCOMPARE(edited.back(), other([](Workspace& w) { w.clutch = 0; }));
        part<QCheckBox>(page, "workspace-bump").click();
        QCOMPARE(edited.back(), other([](Workspace& w) { w.bump = false; }));
        // An axis that another one had: they change places.
        emit part<QComboBox>(page, "workspace-axis-1").activated(3); // device -y
        QCOMPARE(edited.back().axes, withAxis(workspace.axes, 0, -2));
        QCOMPARE(edited.size(), 6u);
        const std::size_t told = edited.size();
        page.show(edited.back(), 0, 0, true); // shown without telling anybody
        QCOMPARE(edited.size(), told);
        COMPARE_SHOWN(shownIn(page), "workspace-no-button");
    }

    void whatIsBeyondTheShellIsSaid() {
        WorkspaceFields page;
        const auto says = [&](bool possible, const Vec3& handle, double border) {
            page.show({}, 0, 0.1, possible);
            page.follow(handle, border);
            return !part<QLabel>(page, "workspace-beyond").isHidden();
        };
        QVERIFY(says(true, {0, 0.03, 0.04}, 0.049));
        QVERIFY(!says(true, {0, 0.03, 0.04}, 0.051));
        QVERIFY(!says(true, {0, 0.03, 0.04}, 0)); // there is none
        QVERIFY(!says(false, {0, 0.03, 0.04}, 0.049));
    }

    void axesAreSetByMoving() {
        WorkspaceFields page;
        page.show({}, 0, 0.1, true);
        std::vector<Workspace> edited;
        connect(&page, &WorkspaceFields::edited, &page, [&](const Workspace& now) { edited.push_back(now); });
        QSignalSpy begun(&page, &WorkspaceFields::captureBegun);
        auto& button = part<QPushButton>(page, "workspace-capture");
        auto& task = part<QLabel>(page, "workspace-task");
        auto& bar = *page.findChild<QProgressBar*>();
        page.follow({0.1, 0, 0}); // nothing is captured yet
        button.click();
        QCOMPARE(begun.size(), 1);
        QVERIFY(page.capturing());
        QCOMPARE(task.text(), "1 of 3: move the handle to the right");
        QVERIFY(!task.isHidden());
        QVERIFY(!bar.isHidden());
        QCOMPARE(button.text(), "Leave the axes as they were");
        page.follow({0, 0, 0});
        page.follow({0, 0, 0.021}); // of four tenths of the radius
        QCOMPARE(bar.value(), 52);
        page.follow({0, 0, 0.041});
        QCOMPARE(task.text(), "2 of 3: move the handle up");
        QCOMPARE(bar.value(), 0);
        page.follow({0, 0, 0.041});
        page.follow({-0.041, 0, 0.041});
        QCOMPARE(task.text(), "3 of 3: move the handle toward you");
        QVERIFY(edited.empty());
        page.follow({-0.041, 0, 0.041});
        page.follow({-0.041, 0.041, 0.041});
        QVERIFY(!page.capturing());
        QCOMPARE(edited.size(), 1u);
        QCOMPARE(edited[0].axes, (AxisMap{3, -1, 2}));
        QVERIFY(task.isHidden());
        QVERIFY(bar.isHidden());
        QCOMPARE(button.text(), "Set the axes by moving");
        // Given up, by hand or because the device is gone.
        button.click();
        button.click();
        QVERIFY(!page.capturing());
        page.beginCapture();
        page.show({}, 0, 0.1, false);
        QVERIFY(!page.capturing());
        page.beginCapture(); // a simulated hand has none
        QVERIFY(!page.capturing());
        QCOMPARE(edited.size(), 1u);
        QCOMPARE(begun.size(), 3);
    }

    /// Four tenths of the radius, 10 mm at least, 30 mm where it is not known.
    void howFarAMotionHasToGo() {
        for (const auto& [radius, reach] : {std::pair(0.1, 0.04), {0.01, 0.01}, {0.0, 0.03}}) {
            WorkspaceFields page;
            page.show({}, 0, radius, true);
            page.beginCapture();
            page.follow({0, 0, 0});
            page.follow({0.98 * reach, 0, 0});
            COMPARE_CONTAINS(part<QLabel>(page, "workspace-task").text(), "1 of 3");
            page.follow({1.02 * reach, 0, 0});
            COMPARE_CONTAINS(part<QLabel>(page, "workspace-task").text(), "2 of 3");
        }
    }

    void devicesAreListed() {
        Loops loops;
        Shelf shelf;
        DeviceLink link(loops.engine);
        DeviceConnect page(link);
        COMPARE_SHOWN(shownIn(page), "connect-looking");
        QVERIFY(!wantsPermission(link));
        link.setCatalogue(shelf);
        QTRY_COMPARE(link.devices().size(), std::size_t(4));
        auto& list = part<QTreeWidget>(page, "device-list");
        QTRY_COMPARE(list.topLevelItemCount(), 4);
        QVERIFY(wantsPermission(link));
        COMPARE_SHOWN(shownIn(page), "connect");
        QCOMPARE(page.chosen(), "simulated");
        const auto why = [&](const char* button) { return part<QPushButton>(page, button).toolTip(); };
        QCOMPARE(why("device-connect-button"), "This device is in use already.");
        QCOMPARE(why("device-disconnect-button"), "No device is connected.");
        QCOMPARE(why("device-add-button"), "A hand has this device already.");
        QSignalSpy connected(&page, &DeviceConnect::connectPressed),
            let(&page, &DeviceConnect::disconnectPressed),
            permitted(&page, &DeviceConnect::permissionPressed),
            changed(&page, &DeviceConnect::chosenChanged);
        list.setCurrentItem(list.topLevelItem(1));
        QCOMPARE(page.chosen(), "arm");
        QCOMPARE(changed.size(), 1);
        QVERIFY(part<QPushButton>(page, "device-connect-button").isEnabled());
        QCOMPARE(why("device-connect-button"), "Make the chosen device ready, step by step");
        COMPARE_CONTAINS(why("device-add-button"), QStringLiteral("as one more hand"));
        part<QPushButton>(page, "device-connect-button").click();
        emit list.itemActivated(list.currentItem(), 0);
        QCOMPARE(connected.size(), 2);
        list.setCurrentItem(list.topLevelItem(2)); // cannot be used
        QCOMPARE(page.chosen(), "");
        QVERIFY(!part<QPushButton>(page, "device-connect-button").isEnabled());
        for (const char* button : {"device-connect-button", "device-add-button"})
            QCOMPARE(why(button), "What is chosen cannot be used; its row says why.");
        list.setCurrentItem(list.topLevelItem(3)); // a remark is none
        QCOMPARE(page.chosen(), "");
        part<QPushButton>(page, "device-permit").click();
        QCOMPARE(permitted.size(), 1);
        QVERIFY(!part<QPushButton>(page, "device-disconnect-button").isEnabled());
        QCOMPARE(let.size(), 0);
        page.showCommand(QStringLiteral("Type this:"), QStringLiteral("sudo true"));
        COMPARE_SHOWN(shownIn(page), "connect-command");
        part<QPushButton>(page, "device-permit-copy").click();
        QCOMPARE(QGuiApplication::clipboard()->text(), "sudo true");
        page.showCommand(QStringLiteral("It is done."), {});
        QVERIFY(part<QLineEdit>(page, "device-permit-command").isHidden());
        QVERIFY(part<QPushButton>(page, "device-permit-copy").isHidden());
        QVERIFY(!part<QLabel>(page, "device-permit-sentence").isHidden());
        // What cannot be made ready says so below, and may be tried again.
        link.choose(QStringLiteral("arm"));
        QTRY_VERIFY(!link.preparing());
        QVERIFY(part<QPushButton>(page, "device-disconnect-button").isEnabled());
        QCOMPARE(part<QLabel>(page, "device-failure").text(), "It does not answer: switch it on.");
        part<QPushButton>(page, "device-disconnect-button").click();
        QCOMPARE(let.size(), 1);
        link.choose(kSimulatedDevice);
    }

    void atAServerTheDeviceIsThere() {
        Loops loops;
        DeviceLink link(loops.engine);
        DeviceConnect page(link);
        page.setLacksRealTime(true);
        page.showServer(QStringLiteral("lab:51270"), QStringLiteral("Example arm"));
        COMPARE_SHOWN(shownIn(page), "connect-server");
        QCOMPARE(page.whyNotConnect(), "The device is at the haptic server, and is chosen there.");
        QCOMPARE(page.whyNotAdd(), page.whyNotConnect());
        page.showServer(QStringLiteral("lab:51270"), {});
        COMPARE_CONTAINS(part<QLabel>(page, "device-at-server").text(),
                         QStringLiteral("lab:51270 is not there"));
    }

    void theDockTellsTheState() {
        Loops loops;
        DeviceLink link(loops.engine);
        DevicePanel panel(link);
        panel.resize(320, 700);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.display(loops.engine);
        COMPARE_SHOWN(shownIn(panel).section(QStringLiteral("  QStackedWidget"), 0, 0), "device-stopped");
        VERIFY_RESULT(loops.engine.start());
        panel.display(loops.engine);
        QCOMPARE(part<QLabel>(panel, "device-state").text(), "forces off");
        auto& arm = part<QPushButton>(panel, "device-arm");
        QCOMPARE(arm.text(), "Arm");
        QVERIFY(arm.isEnabled());
        QSignalSpy pressed(&panel, &DevicePanel::armPressed);
        arm.click();
        QCOMPARE(pressed[0][0].toBool(), true);
        loops.engine.setArmed(true);
        panel.display(loops.engine);
        COMPARE_SHOWN(shownIn(panel).section(QStringLiteral("  QStackedWidget"), 0, 0), "device-armed");
        arm.click();
        QCOMPARE(pressed[1][0].toBool(), false);
        auto& pages = *panel.findChild<QStackedWidget*>();
        for (int i = 0; i < 4; ++i) {
            auto& tab = part<QToolButton>(panel, qPrintable(QStringLiteral("device-page-%1").arg(i)));
            tab.click();
            QCOMPARE(pages.currentIndex(), i);
            for (int k = 0; k < 4; ++k)
                QCOMPARE(
                    part<QToolButton>(panel, qPrintable(QStringLiteral("device-page-%1").arg(k))).isChecked(),
                    k == i);
        }
        panel.showPage(DevicePanel::Page::Live);
        QCOMPARE(pages.currentIndex(), 1);
        panel.display(loops.engine);
        QVERIFY(!part<QLabel>(panel, "device-rate").text().isEmpty());
        QVERIFY(part<QLabel>(panel, "trial-limits").text().isEmpty()); // it is not to be seen
        // What is not to be seen is left as it is, but the axes follow the handle.
        panel.hide();
        loops.engine.setArmed(false);
        panel.display(loops.engine);
        QCOMPARE(arm.text(), "Forces off");
        (void)loops.engine.stop();
    }
};

TACTUM_GUI_TEST(TestDevicePages)

} // namespace test_device_pages

#include "test_device_pages.moc"
