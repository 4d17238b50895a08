// A Falcon in the window, from the plug to the touch: the program's own registry and driver, the real libusb,
// and an emulated device in an emulated hand.
#include <QAction>
#include <QTest>
#include <QTreeWidget>

#include "core/safety/force_gate.h"
#include "device/profile.h"
#include "device/registry.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/self_test_desk.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/engine/device_link.h"

namespace test_falcon_window {

using namespace tactum;
using namespace tactum::test;

namespace {

const QString kFalcon = QStringLiteral("falcon:1-%1").arg(kSocket);

/// The program beside a Falcon that was just plugged in, and a person who does what the window asks for.
struct Desk {
    Desk() {
        qputenv("TACTUM_FALCON_FIRMWARE", QByteArray::fromStdString(bench.firmware()));
        bench.device->leadGrip(kAbove);
        program.window->setCatalogue(registry);
        program.command("device-panel").trigger();
        QObject::connect(&link(), &DeviceLink::preparationChanged, program.window.get(), [this] {
            if (!link().preparation().request.isEmpty()) bench.device->homeByHand();
        });
    }
    ~Desk() { qunsetenv("TACTUM_FALCON_FIRMWARE"); }

    DeviceLink& link() { return program.window->devices(); }
    const ServoTelemetry& servo() { return program.engine.servo(); }
    bool connected() {
        return test::waitFor([this] { return link().current() == kFalcon; });
    }
    void arm() {
        program.engine.setArmed(false);
        program.frames(3);
        program.engine.setArmed(true);
    }
    /// Leads the grip from above into the top of the cube until it pushes back. A machine that is busy with
    /// others is late, or lets the proxy begin anew at the finger, inside: then the person arms anew and
    /// comes from above once more.
    bool feels() {
        bool inside = false;
        bench.device->leadGrip(kAbove);
        return test::waitFor([&] {
            const bool faulty = isFault(servo().inhibit);
            if (faulty || (inside && program.touch().proxy.y() < kTop)) {
                bench.device->leadGrip(kAbove);
                inside = false;
                if (faulty) arm();
            }
            if (!inside && bench.device->gripArrived() && servo().finger.y() > kTop) {
                program.engine.restartProxy();
                program.frames(10); // or a proxy loop that is late would begin inside, and feel nothing
                bench.device->leadGrip(kInside);
                inside = true;
            }
            return inside && servo().gain == 1 && bench.device->force().y() > 1;
        });
    }

    static constexpr double kTop = 0.02; ///< of the cube
    static const Vec3 kAbove, kInside;

    FalconBench bench; // outlives the window
    DeviceRegistry registry{{.hand = {}, .profiles = {}, .program = {}}};
    TouchedWindow program;
};

/// The cube's top is 0.02 m above the workspace's centre.
const Vec3 Desk::kAbove(0, 0.03, 0);
const Vec3 Desk::kInside(0, 0.005, 0);

} // namespace

class TestFalconWindow : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void fromThePlugToTheTouch() {
        Desk desk;
        QVERIFY(desk.program.open(writeCube(folder_, 0.4)));
        QVERIFY(test::waitFor([&] { return desk.link().find(kFalcon) != nullptr; }));
        desk.link().choose(kFalcon);
        QVERIFY2(desk.connected(), qPrintable(desk.link().preparation().failure));
        for (const Preparation::Step& step : desk.link().preparation().steps)
            QCOMPARE(step.state, StepState::Done);
        QVERIFY(!desk.program.engine.armed());
        QVERIFY(desk.program.engine.device().real);
        QCOMPARE(desk.bench.device->motors(), FalconLegs{});
        desk.arm();
        QVERIFY(desk.feels());
        if (const QString file = qEnvironmentVariable("TACTUM_PICTURE"); !file.isEmpty()) {
            desk.program.frames(60);
            desk.program.window->grab().save(file);
        }
    }

    void itsFirmwareIsChosenInTheWindow() {
        const QTemporaryDir settings;
        const QByteArray home = qgetenv("HOME");
        qputenv("XDG_CONFIG_HOME", settings.path().toLocal8Bit());
        qputenv("HOME", settings.path().toLocal8Bit());
        Desk desk;
        qunsetenv("TACTUM_FALCON_FIRMWARE");
        const auto lacks = [&] {
            const DeviceListing* listing = desk.link().find(kFalcon);
            return listing && !listing->lacks.empty();
        };
        QTRY_VERIFY_WITH_TIMEOUT(lacks(), kPatience);
        desk.link().choose(kFalcon);
        QTRY_COMPARE_WITH_TIMEOUT(desk.link().preparation().state, Preparation::State::Failed, kPatience);
        COMPARE_CONTAINS(desk.link().preparation().failure, QStringLiteral("firmware"));
        desk.link().supply(kFalcon, QString::fromStdString(desk.bench.firmware()));
        QVERIFY2(desk.connected(), qPrintable(desk.link().preparation().failure));
        QTRY_VERIFY_WITH_TIMEOUT(!lacks(), kPatience);
        qputenv("HOME", home);
        qunsetenv("XDG_CONFIG_HOME");
    }

    void pulledOutAndBackAgain() {
        Desk desk;
        desk.bench.device->startFirmware(true);
        QVERIFY(desk.program.open(writeCube(folder_, 0.4)));
        QVERIFY(test::waitFor([&] { return desk.link().find(kFalcon) != nullptr; }));
        desk.link().choose(kFalcon);
        QVERIFY2(desk.connected(), qPrintable(desk.link().preparation().failure));
        desk.arm();
        QVERIFY(desk.feels());
        FalconBench::unplug();
        QVERIFY(test::waitFor([&] { return desk.link().lost(); }));
        QVERIFY(!desk.program.engine.armed());
        desk.bench.device->leadGrip(Desk::kAbove);
        desk.bench.plug();
        QVERIFY(desk.connected());
        QVERIFY(!desk.link().lost());
        QVERIFY(!desk.program.engine.armed());
        QCOMPARE(desk.bench.device->motors(), FalconLegs{});
        QVERIFY(!desk.bench.device->firstHadTorque());
        desk.arm();
        QVERIFY(desk.feels());
    }

    /// Its x is turned round: the window's self-test says so, and what it measured of the rest is the
    /// device's from the next connection on.
    void theSelfTestNamesWhatIsWrong() {
        SelfTestDesk desk;
        QVERIFY(desk.connectIt());
        SelfTestPerson& person = desk.person;
        person.open();
        person.click("self-test-start");
        QVERIFY(person.goThrough());
        QVERIFY2(person.shown("self-test-verdict"), qPrintable(person.text("self-test-failure")));
        COMPARE_CONTAINS(person.text("self-test-found"), QStringLiteral("x runs the other way"));
        QCOMPARE(desk.bench.device->motors(), FalconLegs{});
        person.click("self-test-keep");
        QTRY_VERIFY_WITH_TIMEOUT(!person.text("self-test-told").isEmpty(), kPatience);
        const auto kept = profileOf("falcon", desk.profiles.path().toStdString());
        VERIFY_RESULT(kept);
        const double before = profileOf("falcon", {})->info.damping;
        QVERIFY2(kept->info.damping != before, qPrintable(person.text("self-test-found")));
        person.click("self-test-close");
        QVERIFY(desk.connectIt());
        QCOMPARE(desk.program.engine.device().damping, kept->info.damping);
        QVERIFY(!desk.program.engine.armed());
    }
};

TACTUM_GUI_TEST(TestFalconWindow)

} // namespace test_falcon_window

#include "test_falcon_window.moc"
