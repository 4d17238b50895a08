// What is felt vibrates in a gamepad: switched on in the menu, remembered, and over when it should be. The
// gamepads are SDL's own; what their motors are told is noted.
#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/rumble/virtual_pad.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/preferences.h"
#include "ui/rumble/rumble_link.h"
#include "ui/showing/playback.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_rumble {

using namespace tactum;
using namespace tactum::test;

namespace {

/// A window on the wall of textures, whose middle is where brick and tiles meet.
struct Wall {
    Wall() {
        if (!program.open(QStringLiteral(TACTUM_RESOURCES "/scenes/texture-wall.glb"))) qFatal("no wall");
        if (!program.fullForce()) qFatal("no force");
    }
    RumbleLink& link() { return *program.window->findChild<RumbleLink*>(); }
    void switchOn(std::size_t pads = 1) {
        program.command("rumble").trigger();
        if (!waitFor([&] { return link().pads().size() == pads; })) qFatal("the gamepads are not found");
    }
    QString notice() { return program.window->findChild<NoticeBar*>()->text(); }
    /// A hand that strokes to and fro until the condition holds.
    template <class Condition> bool strokeUntil(Condition condition) {
        const QPoint middle = program.centre();
        if (!std::exchange(held, true)) {
            program.press(middle);
            program.frames(20);
            program.wheel(middle, 4);
        }
        return waitFor([&] {
            program.moveTo(middle + QPoint(int(60 * std::sin(0.1 * ++moves)), 0));
            program.frames(1);
            return condition();
        });
    }
    void letGo() { program.release(program.centre()); }
    /// What the menu offers below the switch.
    QStringList entries() {
        QStringList texts;
        for (const QAction* each : menu().actions())
            if (!each->isSeparator() && each->objectName() != QLatin1String("rumble"))
                texts << each->text().remove(u'&') + (each->isChecked() ? QStringLiteral(" *") : QString());
        return texts;
    }
    QMenu& menu() {
        auto* menu = program.window->menuBar()->findChild<QMenu*>(QStringLiteral("Device/&Gamepad"));
        emit menu->aboutToShow();
        return *menu;
    }

    TouchedWindow program;
    bool held = false;
    int moves = 0;
};

bool turns(const VirtualPad& pad) {
    return pad.last().low > 0 || pad.last().high > 0;
}

} // namespace

class TestRumble : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        QSettings().clear();
        Preferences::instance().set(Preferred::Vibration, 4);
    }

    void aStrokeVibratesUntilTheHandLetsGo();
    void withoutTheSwitchNothingVibrates();
    void aStopEndsIt();
    void whoTurnsToAnotherProgramFeelsNothing();
    void whatIsThereIsSaid();
    void theChoiceIsRemembered();
    void aRecordingVibrates();
};

void TestRumble::aStrokeVibratesUntilTheHandLetsGo() {
    VirtualPad pad("Pad of a test");
    Wall wall;
    wall.switchOn();
    QCOMPARE(wall.notice(), QStringLiteral("Pad of a test vibrates with what is felt."));
    QVERIFY(wall.strokeUntil([&] { return pad.told().size() > 20 && turns(pad); }));
    wall.letGo();
    QTRY_VERIFY(!turns(pad));
}

void TestRumble::withoutTheSwitchNothingVibrates() {
    VirtualPad pad("Pad of a test");
    Wall wall;
    wall.program.stroke();
    QTRY_COMPARE(wall.program.engine.proxy().output.contacts, 0);
    wall.switchOn();
    wall.program.command("rumble").trigger();
    wall.program.stroke();
    QVERIFY(pad.told().empty());
}

void TestRumble::aStopEndsIt() {
    VirtualPad pad("Pad of a test");
    Wall wall;
    wall.switchOn();
    QVERIFY(wall.strokeUntil([&] { return turns(pad); }));
    wall.program.command("stop").trigger();
    QTRY_VERIFY(!turns(pad));
    const std::size_t told = pad.told().size();
    wall.held = false;
    QVERIFY(wall.strokeUntil([&] { return wall.moves > 100; }));
    QCOMPARE(pad.told().size(), told);
    wall.letGo();
}

void TestRumble::whoTurnsToAnotherProgramFeelsNothing() {
    VirtualPad pad("Pad of a test");
    Wall wall;
    wall.switchOn();
    QVERIFY(wall.strokeUntil([&] { return turns(pad); }));
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    QVERIFY(wall.strokeUntil([&] { return !turns(pad); }));
    const std::size_t told = pad.told().size();
    wall.moves = 0;
    QVERIFY(wall.strokeUntil([&] { return wall.moves > 50; }));
    QCOMPARE(pad.told().size(), told);
    emit qApp->applicationStateChanged(Qt::ApplicationActive);
    QVERIFY(wall.strokeUntil([&] { return turns(pad); }));
    wall.letGo();
}

void TestRumble::whatIsThereIsSaid() {
    Wall wall;
    QCOMPARE(wall.entries(), QStringList{"Gamepads are looked for while this is on"});
    wall.program.command("rumble").trigger();
    QTRY_COMPARE(
        wall.notice(),
        QStringLiteral("No gamepad that vibrates is connected; one that is plugged in vibrates at once."));
    QCOMPARE(wall.entries(), QStringList{"No gamepad that vibrates is connected"});
    VirtualPad pad("Black & white", 1), other("Another", 2);
    QTRY_COMPARE(wall.notice(), QStringLiteral("Black & white vibrates with what is felt."));
    QTRY_COMPARE(wall.link().pads().size(), std::size_t(2));
    COMPARE_CONTAINS(wall.entries().join(u'|'), QStringLiteral("white *|Another"));
    COMPARE_CONTAINS(wall.menu().actions()[2]->text(), QStringLiteral("&& white")); // no letter for Alt
    pad.unplug();
    QTRY_COMPARE(wall.notice(), QStringLiteral("Another vibrates with what is felt."));
    other.unplug();
    QTRY_COMPARE(wall.notice(),
                 QStringLiteral("Another is gone: nothing vibrates until a gamepad is connected."));
    QVERIFY(wall.program.command("rumble").isChecked());
}

void TestRumble::theChoiceIsRemembered() {
    VirtualPad first("The first", 1), second("The second", 2);
    {
        Wall wall;
        QVERIFY(!wall.program.command("rumble").isChecked()); // nobody is shaken unasked
        wall.switchOn(2);
        QCOMPARE(wall.entries(), (QStringList{"The first *", "The second"}));
        wall.menu().actions().back()->trigger();
        QCOMPARE(wall.entries(), (QStringList{"The first", "The second *"}));
        QCOMPARE(wall.notice(), QStringLiteral("The second vibrates with what is felt."));
    }
    Wall again;
    QVERIFY(again.program.command("rumble").isChecked());
    QTRY_COMPARE(again.link().pads().size(), std::size_t(2));
    QCOMPARE(again.link().used()->name, std::string("The second"));
    COMPARE_LACKS(again.notice(), QStringLiteral("vibrates")); // as yesterday
    QVERIFY(again.strokeUntil([&] { return turns(second); }));
    QVERIFY(!turns(first));
    again.letGo();
}

void TestRumble::aRecordingVibrates() {
    VirtualPad pad("Pad of a test");
    Wall wall;
    wall.switchOn();
    wall.program.window->open(QStringLiteral(TACTUM_REPLAYS "/few-bumps.tactum-recording"));
    auto* playback = wall.program.window->findChild<Playback*>();
    QTRY_VERIFY(playback->active());
    QTest::keyClick(&wall.program.window->view(), Qt::Key_Space);
    QTRY_VERIFY(turns(pad));
}

TACTUM_GUI_TEST(TestRumble)

} // namespace test_rumble

#include "test_rumble.moc"
