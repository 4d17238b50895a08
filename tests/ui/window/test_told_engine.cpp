// What the window makes of what its engine tells: faults and pauses, hands that come and go, buttons of the
// device, what is touched. Wrong itself if the engine told something that a real one never does: the states
// are those of a HandReport, each alone.
#include <algorithm>

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>

#include "core/safety/inhibit_words.h"
#include "tests/support/as_shown.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/rumble/virtual_pad.h"
#include "tests/ui/window/told_window.h"
#include "ui/engine/device_link.h"
#include "ui/engine/guard_watch.h"
#include "ui/panels/health_panel.h"
#include "ui/panels/status_strip.h"
#include "ui/rumble/rumble_link.h"
#include "ui/showing/recording_saver.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_told_engine {

using namespace tactum;
using tactum::testing::knownScene;

namespace {

DeviceInfo armOf(const char* name) {
    DeviceInfo device;
    device.name = name;
    device.maxForce = 8;
    device.continuousForce = 3;
    device.workspaceRadius = 0.05;
    device.rate = 1000;
    device.buttons = 2;
    return device;
}

void tellArm(test::ToldEngine& engine) {
    for (std::size_t hand = 0; hand < engine.of.size(); ++hand) {
        engine.of[hand].device = armOf(hand == 0 ? "Arm" : "Other");
        engine.of[hand].servo.rate = 1000;
        engine.of[hand].servo.gain = 1;
    }
}

/// The buttons of the notice that a person can press.
QStringList offered(const ToldWindow& told) {
    QStringList texts;
    const auto& notice = *told.window->findChild<NoticeBar*>();
    if (notice.isHidden()) return {};
    for (const auto* each : notice.findChildren<QPushButton*>())
        if (!each->isHidden()) texts << each->text();
    return texts;
}

void press(const ToldWindow& told, const QString& text) {
    for (auto* each : told.window->findChild<NoticeBar*>()->findChildren<QPushButton*>())
        if (!each->isHidden() && each->text() == text) return each->click();
    qFatal("no button %s", qPrintable(text));
}

/// Which hands have force, and whose faults are known.
QString forcesOf(const ToldWindow& told) {
    QStringList words;
    for (const HandReport& hand : told.engine.of)
        words << (hand.armed ? QStringLiteral("on") : QStringLiteral("off"));
    return QStringLiteral("  forces %1; armed %2, stop %3; offers: %4\n")
        .arg(words.join(u' '), told.command("armed").isChecked() ? "on" : "off",
             told.command("stop").isEnabled() ? "on" : "off", offered(told).join(u','));
}

} // namespace

class TestToldEngine : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() { test::speakEnglish(); }
    void init() { useSettingsIn(folders_.next()); }

    void faultsAreSaidAndArmedAway();
    void pausesAreSaid();
    void handsOfTheServerComeAndGo();
    void buttonsOfTheDevice();
    void whatIsTouchedIsNamed();
    void theRiskIsTaken();
    void devicesAreSaid();
    void gamepadsAreSaidAndChosen();
};

void TestToldEngine::faultsAreSaidAndArmedAway() {
    ToldWindow told(2, tellArm);
    testing::adopt(told.document, knownScene());
    told.catchUp();
    auto effects = told.effects();
    QString forces;
    const auto note = [&](const QString& words, const std::function<void()>& act) {
        effects.note(words, [&] {
            act();
            told.frames(3);
            forces += words + u'\n' + forcesOf(told);
        });
    };
    note(QStringLiteral("armed"), [&] { told.command("armed").trigger(); });
    note(QStringLiteral("stopped"), [&] { told.command("stop").trigger(); });
    note(QStringLiteral("armed"), [&] { told.command("armed").trigger(); });
    note(QStringLiteral("switched off"), [&] { told.command("armed").trigger(); });
    for (std::size_t i = 0; i < kInhibitReasons; ++i) {
        const auto why = InhibitReason(i);
        const QString name = QStringLiteral("%1: ").arg(QLatin1String(inhibitWords(why).what));
        for (std::size_t hand = 0; hand < 2; ++hand) {
            if (hand == 1 && !isFault(why)) continue;
            note(name + QString::number(hand), [&] {
                told.engine.setAllArmed(true);
                told.engine.of[hand].servo.inhibit = why;
            });
            if (isFault(why)) {
                note(QStringLiteral("it is over"),
                     [&] { told.engine.of[hand].servo.inhibit = InhibitReason::NotArmed; });
                note(QStringLiteral("armed again"),
                     [&] { emit told.window->findChild<StatusStrip*>()->armPressed(); });
            }
            told.engine.of[hand].servo.inhibit = InhibitReason::Nothing;
        }
    }
    COMPARE_SHOWN(effects.text(), "told-faults");
    COMPARE_SHOWN(forces, "told-forces");
}

void TestToldEngine::pausesAreSaid() {
    ToldWindow told(1, tellArm);
    testing::adopt(told.document, knownScene());
    told.catchUp();
    ServoTelemetry& servo = told.engine.of[0].servo;
    auto& status = *told.window->findChild<StatusStrip*>();
    testing::States states(test::shownIn(status));
    const auto note = [&](const char* words, const std::function<void()>& act) {
        act();
        told.frames(8);
        states.note(QLatin1String(words), test::shownIn(status));
    };
    note("armed", [&] { told.command("armed").trigger(); });
    note("a stall", [&] {
        ++servo.pauses;
        servo.lastPause = InhibitReason::Stall;
        servo.inhibit = InhibitReason::Rising;
        servo.gain = 0.4;
    });
    note("risen", [&] {
        servo.inhibit = InhibitReason::Nothing;
        servo.gain = 1;
    });
    note("warm", [&] { servo.heat = 0.9; });
    note("an oscillation", [&] {
        ++servo.oscillations;
        servo.stiffnessScale = 0.5;
    });
    note("a heavy scene", [&] {
        ++told.engine.proxyTold.stepsDown;
        told.engine.proxyTold.fidelity = Fidelity::NoTexture;
    });
    note("a touch", [&] {
        told.engine.proxyTold.output.contacts = 2;
        servo.force = {0, 3, 4};
    });
    note("off", [&] { told.command("stop").trigger(); });
    note("unread", [&] { ++servo.invalidSamples; });
    note("it stands still", [&] { told.engine.of[0].standsStill = true; });
    COMPARE_SHOWN(states.text(), "told-pauses");
    QStringList events;
    for (const HealthEvent& event : told.window->findChild<GuardWatch*>()->events())
        events << QStringLiteral("%1%2\n  %3").arg(event.fault ? "fault: " : "", event.what, event.sentences);
    COMPARE_SHOWN(events.join(u'\n'), "told-events");
}

void TestToldEngine::handsOfTheServerComeAndGo() {
    ToldWindow told(1, tellArm);
    testing::adopt(told.document, knownScene());
    told.catchUp();
    auto effects = told.effects();
    QString chosen;
    const auto note = [&](const char* words, const std::function<void()>& act) {
        effects.note(QLatin1String(words), [&] {
            act();
            told.frames(3);
            chosen += QStringLiteral("%1: hand %2 of %3\n")
                          .arg(QLatin1String(words))
                          .arg(told.engine.chosen)
                          .arg(told.engine.of.size());
        });
    };
    note("one", [] {});
    note("another comes", [&] {
        told.engine.of.resize(2);
        told.engine.of[1].device = armOf("Other");
    });
    note("the next", [&] { told.command("hand-next").trigger(); });
    note("a third", [&] {
        told.engine.of.resize(3);
        told.engine.of[2].device = armOf("Arm");
    });
    for (int i = 0; i < 3; ++i)
        note("the next", [&] { told.command("hand-next").trigger(); });
    note("armed", [&] { told.command("armed").trigger(); });
    note("two go", [&] {
        told.engine.of.resize(1);
        told.engine.chosen = 0;
    });
    told.engine.of.resize(3);
    told.frames(3);
    told.engine.restarted.clear();
    testing::adopt(told.document, knownScene()); // another scene: no proxy stays inside of it
    told.catchUp();
    told.frames(3);
    std::ranges::sort(told.engine.restarted);
    const auto again = std::ranges::unique(told.engine.restarted);
    told.engine.restarted.erase(again.begin(), again.end());
    QCOMPARE(told.engine.restarted, (std::vector<std::size_t>{1, 2})); // the mouse puts its own elsewhere
    COMPARE_SHOWN(effects.text(), "told-hands");
    COMPARE_SHOWN(chosen, "told-hands-chosen");
}

void TestToldEngine::buttonsOfTheDevice() {
    ToldWindow told(2, tellArm);
    testing::adopt(told.document, knownScene());
    told.catchUp();
    auto effects = told.effects();
    DeviceLink& link = told.window->devices();
    const auto note = [&](const char* words, const std::function<void()>& act) {
        effects.note(QLatin1String(words), [&] {
            act();
            told.frames(3);
        });
    };
    QVERIFY(told.command("dead-man").isEnabled());
    note("held by a button", [&] { told.command("dead-man").trigger(); });
    note("and not", [&] { told.command("dead-man").trigger(); });
    QCOMPARE(told.engine.deadMen, (std::vector<bool>{false, true, false}));
    note("pressed without force", [&] { link.stop(1).pressed = true; });
    link.stop(1).pressed = false;
    told.command("armed").trigger();
    QVERIFY(told.engine.of[0].armed && told.engine.of[1].armed);
    note("pressed", [&] { link.stop(1).pressed = true; });
    QVERIFY(!told.engine.of[0].armed && !told.engine.of[1].armed);
    COMPARE_SHOWN(effects.text(), "told-buttons");
    ToldWindow without(1);
    QVERIFY(!without.command("dead-man").isEnabled());
}

void TestToldEngine::whatIsTouchedIsNamed() {
    ToldWindow told(1, tellArm);
    testing::adopt(told.document, knownScene());
    told.catchUp();
    auto effects = told.effects();
    HapticOutput& touch = told.engine.proxyTold.output;
    effects.note(QStringLiteral("nothing was touched"), [&] { told.command("select-touched").trigger(); });
    for (const SurfaceRef ref : {testing::kFloor, testing::kTop}) {
        const World& world = *told.window->publisher().world();
        for (std::size_t i = 0; i < world.bodies.size(); ++i)
            if (world.bodies[i].object == ref.object) touch.contact[0].body = std::uint32_t(i);
        touch.contact[0].surface = ref.surface;
        touch.contact[0].normalForce = 1;
        touch.contacts = 1;
        told.frames(4);
        touch.contacts = 0;
        told.frames(4);
        effects.note(QStringLiteral("touched %1.%2").arg(ref.object).arg(ref.surface),
                     [&] { told.command("select-touched").trigger(); });
    }
    COMPARE_SHOWN(effects.text(), "told-touched");
}

void TestToldEngine::theRiskIsTaken() {
    ToldWindow told(1, tellArm);
    testing::adopt(told.document, knownScene());
    told.catchUp();
    auto effects = told.effects();
    auto& panel = *told.window->findChild<HealthPanel*>();
    effects.note(QStringLiteral("above the ceiling"), [&] { emit panel.overrideAsked(true); });
    emit panel.overrideAsked(true);
    QCOMPARE(offered(told), QStringList{QStringLiteral("I take the risk")});
    QCOMPARE(told.engine.overrides, std::vector<bool>());
    press(told, QStringLiteral("I take the risk"));
    emit panel.overrideAsked(false);
    emit panel.overrideAsked(true); // they took it once
    QCOMPARE(told.engine.overrides, (std::vector<bool>{true, false, true}));
    COMPARE_SHOWN(effects.text(), "told-risk");
}

/// What the link between devices and engine tells, and what was recorded.
void TestToldEngine::devicesAreSaid() {
    ToldWindow told(1, tellArm);
    testing::adopt(told.document, knownScene());
    told.catchUp();
    auto effects = told.effects();
    DeviceLink& link = told.window->devices();
    QString offers;
    const auto note = [&](const char* words, const std::function<void()>& act) {
        effects.note(QLatin1String(words), [&] {
            act();
            told.frames(2);
            offers += QStringLiteral("%1: %2\n").arg(QLatin1String(words), offered(told).join(u','));
        });
    };
    const QString arm = QStringLiteral("Arm");
    note("ready", [&] { emit link.ready(arm, false); });
    note("back", [&] { emit link.ready(arm, true); });
    note("armed by the notice", [&] {
        emit link.ready(arm, true);
        press(told, QStringLiteral("Arm"));
    });
    QVERIFY(told.engine.of[0].armed);
    note("away", [&] { emit link.wentAway(arm, false); });
    note("away beside others", [&] { emit link.wentAway(arm, true); });
    note("one beside away", [&] { emit link.besideWentAway(arm, false); });
    note("one beside away beside others", [&] { emit link.besideWentAway(arm, true); });
    note("missing", [&] { emit link.missing({arm, QStringLiteral("Other")}); });
    note("failed", [&] { emit link.failed(QStringLiteral("It failed.")); });
    note("supplied", [&] { emit link.supplied(QStringLiteral("It is kept.")); });
    note("no figures", [&] { emit link.figuresKept(QStringLiteral("They are kept."), true); });
    note("nobody wanted it", [&] { emit link.lent(nullptr, QStringLiteral("It is not there.")); });
    auto& saver = *told.window->findChild<RecordingSaver*>();
    note("recorded", [&] { emit saver.saved(QStringLiteral("/tmp/a.tactum-recording"), false); });
    note("recorded after a fault",
         [&] { emit saver.saved(QStringLiteral("/tmp/b.tactum-recording"), true); });
    note("recorded while it is faulty", [&] {
        told.engine.of[0].servo.inhibit = InhibitReason::TooFast;
        told.frames(3);
        emit saver.saved(QStringLiteral("/tmp/c.tactum-recording"), true);
    });
    told.engine.of[0].servo.inhibit = InhibitReason::NotArmed;
    note("not recorded", [&] { emit saver.failed(QStringLiteral("The disk is full.")); });
    COMPARE_SHOWN(effects.text(), "told-devices");
    COMPARE_SHOWN(offers, "told-offers");
}

void TestToldEngine::gamepadsAreSaidAndChosen() {
    ToldWindow told(1, tellArm);
    auto& menu = *told.window->menuBar()->findChild<QMenu*>(QStringLiteral("Device/&Gamepad"));
    const auto& link = *told.window->findChild<RumbleLink*>();
    QStringList said;
    const auto note = [&](const char* words) {
        emit menu.aboutToShow();
        QStringList entries;
        for (const QAction* each : menu.actions())
            if (!each->isSeparator())
                entries << each->text() + (each->isChecked() ? QStringLiteral(" *") : QString()) +
                               (each->isEnabled() ? QString() : QStringLiteral(" (off)"));
        said << QStringLiteral("%1: %2\n  %3")
                    .arg(QLatin1String(words), told.window->findChild<NoticeBar*>()->text(),
                         entries.join(QStringLiteral("; ")));
    };
    note("off");
    told.command("rumble").trigger();
    QVERIFY(test::waitFor([&] { return !told.window->findChild<NoticeBar*>()->text().isEmpty(); }));
    note("on");
    VirtualPad pad("Black & white", 1), other("Another", 2);
    QVERIFY(test::waitFor([&] { return link.pads().size() == 2; }));
    note("two");
    menu.actions().back()->trigger();
    note("the other one");
    QCOMPARE(link.used()->name, std::string("Another"));
    other.unplug();
    QVERIFY(test::waitFor([&] { return link.pads().size() == 1; }));
    note("unplugged");
    pad.unplug();
    QVERIFY(test::waitFor([&] { return link.pads().empty(); }));
    note("both");
    told.command("rumble").trigger();
    note("off again");
    COMPARE_SHOWN(said.join(u'\n'), "told-gamepads");
}

TACTUM_GUI_TEST(TestToldEngine)

} // namespace test_told_engine

#include "test_told_engine.moc"
