// Devices that come, are made ready, fail, go and lie elsewhere in the scene: what the window and the dock
// Device make of each, which commands are on, what is kept of it. The engine is real and without force, the
// window laid out and never drawn. Wrong itself if a figure of the loops stood in a list: none is written
// down.
#include <clocale>

#include <QApplication>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>

#include "core/runtime/local_engine.h"
#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/fake_devices.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/window_effects.h"
#include "ui/base/style.h"
#include "ui/document/journal.h"
#include "ui/engine/device_link.h"
#include "ui/engine/device_settings.h"
#include "ui/panels/device_connect.h"
#include "ui/panels/device_live.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/workspace_fields.h"
#include "ui/widgets/notice_bar.h"

namespace test_led_devices {

using namespace tactum;
using tactum::testing::knownScene;

namespace {

const QString kArm = QStringLiteral("fake:1-2"), kOther = QStringLiteral("fake:1-4");

/// The program with two arms that can be plugged in.
struct Desk {
    Desk() : catalogue(arm, hand) {
        std::setlocale(LC_NUMERIC, "C");
        other->name = "Other arm";
        other->go = 3;
        catalogue.other = true;
        catalogue.otherDesk = other;
        if (const auto started = engine.start(); !started) qFatal("%s", started.error().text.c_str());
        applyTheme(rememberedTheme());
        window = std::make_unique<MainWindow>(document, engine, hand, QStringList());
        window->resize(1200, 800);
        window->setAttribute(Qt::WA_DontShowOnScreen);
        window->setUpdatesEnabled(false);
        window->show();
        QApplication::setActiveWindow(window.get());
        testing::adopt(document, knownScene());
        command("fold-plots").trigger(); // the first touch unfolds them, and when that is nobody knows
        window->setCatalogue(catalogue);
        until([&] { return link().find(kArm) != nullptr; });
        QTest::qWait(4 * 16); // all is dressed
        effects = std::make_unique<WindowEffects>(
            *window, document, [this] { return !window->publisher().working(); }, [] {});
    }
    ~Desk() {
        window->journal().discard();
        window.reset();
        (void)engine.stop();
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    DeviceLink& link() const { return window->devices(); }
    DevicePanel& panel() const { return *window->findChild<DevicePanel*>(); }
    QAction& command(const char* id) const { return commandOf(*window, id); }
    void until(const std::function<bool()>& reached) {
        if (!test::waitFor(reached)) qFatal("it does not come to that: %s", qPrintable(now));
        QTest::qWait(2 * 16);
    }
    /// Lists the devices again and again until it is seen; too often to see that one sends nothing any more.
    void seen(const std::function<bool()>& reached) {
        until([&] {
            link().look();
            QTest::qWait(16);
            return reached();
        });
    }
    void choose(const char* name) {
        auto& list = *panel().connecting().findChild<QTreeWidget*>(QStringLiteral("device-list"));
        const auto found = list.findItems(QString::fromLatin1(name), Qt::MatchStartsWith);
        if (found.isEmpty()) qFatal("%s is not listed", name);
        list.setCurrentItem(found.front());
    }
    void ready(const QString& id) {
        until([&] { return link().uses(id) && !link().preparing(); });
    }
    void note(const char* words, const std::function<void()>& act) {
        now = QLatin1String(words);
        effects->note(now, [&] {
            act();
            QTest::qWait(2 * 16);
        });
        hands += QStringLiteral("%1: ").arg(QLatin1String(words));
        for (std::size_t i = 0; i < link().hands().count(); ++i)
            hands += QStringLiteral("%1%2%3, ")
                         .arg(link().idOf(i), link().gone(i) ? " (gone)" : "",
                              i == link().hands().chosen() ? " *" : "");
        hands += QStringLiteral("the mouse leads %1; offers %2\n")
                     .arg(link().simulatedHand() ? QString::number(*link().simulatedHand())
                                                 : QStringLiteral("none"),
                          offered().join(u','));
    }
    QStringList offered() const {
        QStringList texts;
        const auto& notice = *window->findChild<NoticeBar*>();
        if (notice.isHidden()) return {};
        for (const auto* each : notice.findChildren<QPushButton*>())
            if (!each->isHidden()) texts << each->text();
        return texts;
    }

    std::shared_ptr<FakeDesk> arm = std::make_shared<FakeDesk>(), other = std::make_shared<FakeDesk>();
    std::shared_ptr<HandTarget> hand = std::make_shared<HandTarget>();
    FakeCatalogue catalogue; // outlives the window
    LocalEngine engine{std::make_unique<SimulatedHand>(hand)};
    Document document;
    std::unique_ptr<MainWindow> window;
    std::unique_ptr<WindowEffects> effects;
    QString hands, now;
};

/// Of the page that connects: what a person reads there and can press.
QString pageOf(const Desk& desk) {
    return test::shownIn(desk.panel().connecting());
}

} // namespace

class TestLedDevices : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() { test::speakEnglish(); }
    void init() { useSettingsIn(folders_.next()); }

    void theyComeAndGo();
    void theyFail();
    void theyLieInTheScene();
    void handsBeside();
};

void TestLedDevices::theyComeAndGo() {
    Desk desk;
    testing::States page(pageOf(desk));
    const auto note = [&](const char* words, const std::function<void()>& act) {
        desk.note(words, act);
        page.note(QLatin1String(words), pageOf(desk));
    };
    note("chosen", [&] { desk.choose("Example arm"); });
    note("the simulated one is chosen", [&] { desk.choose("Simulated hand"); });
    desk.choose("Example arm");
    note("begun", [&] {
        desk.command("device-connect").trigger();
        desk.until([&] { return desk.link().preparation().progress > 0; });
    });
    note("the second step, nobody sees it", [&] {
        desk.arm->go = 1;
        desk.until([&] { return !desk.link().preparation().request.isEmpty(); });
    });
    note("shown", [&] {
        for (auto* each : desk.window->findChild<NoticeBar*>()->findChildren<QPushButton*>())
            if (!each->isHidden() && each->text() == QStringLiteral("Show")) each->click();
    });
    note("ready", [&] {
        desk.arm->go = 3;
        desk.ready(kArm);
    });
    note("unplugged", [&] {
        desk.arm->plugged = false;
        desk.until([&] { return desk.link().lost(); });
    });
    note("plugged in", [&] {
        desk.arm->plugged = true;
        desk.seen([&] { return desk.link().uses(kArm) && !desk.link().preparing(); });
    });
    note("disconnected", [&] {
        desk.command("device-disconnect").trigger();
        desk.until([&] { return !desk.link().uses(kArm); });
    });
    note("none may be used", [&] {
        desk.catalogue.locked = true;
        desk.seen([&] { return desk.link().find(QStringLiteral("locked:1-3")) != nullptr; });
        desk.choose("Locked arm");
    });
    note("it lacks something", [&] {
        desk.catalogue.lacking = true;
        desk.seen([&] { return !desk.link().find(kArm)->lacks.empty(); });
    });
    COMPARE_SHOWN(desk.effects->text(), "devices-go");
    COMPARE_SHOWN(desk.hands, "devices-go-hands");
    COMPARE_SHOWN(page.text(), "devices-go-page");
}

void TestLedDevices::theyFail() {
    Desk desk;
    testing::States page(pageOf(desk));
    const auto note = [&](const char* words, const std::function<void()>& act) {
        desk.note(words, act);
        page.note(QLatin1String(words), pageOf(desk));
    };
    using State = Preparation::State;
    const auto ended = [&](State how) {
        desk.until([&, how] { return desk.link().preparation().state == how; });
    };
    desk.choose("Example arm");
    note("the second step fails", [&] {
        desk.arm->go = 1;
        desk.arm->failAt = 1;
        desk.command("device-connect").trigger();
        ended(State::Failed);
    });
    note("given up", [&] {
        desk.arm->failAt = -1;
        desk.link().tryAgain();
        desk.until([&] { return !desk.link().preparation().request.isEmpty(); });
        desk.link().giveUp();
        ended(State::GivenUp);
    });
    note("it does not open", [&] {
        desk.arm->failOpen = true;
        desk.arm->go = 3;
        desk.link().tryAgain();
        ended(State::Failed);
    });
    note("once more", [&] {
        desk.arm->failOpen = false;
        desk.link().tryAgain();
        desk.ready(kArm);
    });
    note("its driver crashed", [&] {
        desk.arm->broken = true;
        desk.seen([&] { return !desk.link().hands().trouble(0).empty(); });
        desk.seen([&] { return desk.link().mayBegin(kArm); });
    });
    COMPARE_SHOWN(desk.effects->text(), "devices-fail");
    COMPARE_SHOWN(desk.hands, "devices-fail-hands");
    COMPARE_SHOWN(page.text(), "devices-fail-page");
}

void TestLedDevices::theyLieInTheScene() {
    Desk desk;
    DevicePanel& panel = desk.panel();
    const auto settings = [&] { return test::shownIn(panel.workspace()) + test::shownIn(panel.live()); };
    desk.note("the mouse leads", [&] { emit panel.workspace().centrePressed(); });
    desk.arm->go = 3;
    desk.choose("Example arm");
    desk.command("device-connect").trigger();
    desk.ready(kArm);
    testing::States states(settings());
    const auto note = [&](const char* words, const std::function<void()>& act) {
        desk.note(words, act);
        states.note(QLatin1String(words), settings());
    };
    note("a button stops", [&] { emit panel.live().stopButtonChosen(2); });
    note("all of the hand holds it", [&] { emit panel.live().graspChosen(true); });
    Workspace workspace;
    workspace.scale = 2;
    workspace.axes = withAxis(workspace.axes, 0, 2);
    workspace.clutch = 1;
    workspace.bump = true;
    note("scale, axes, clutch and bump", [&] { emit panel.workspace().edited(workspace); });
    note("the clutch has the button that stopped", [&] {
        workspace.clutch = 3;
        emit panel.workspace().edited(workspace);
    });
    note("it stops again", [&] { emit panel.live().stopButtonChosen(1); });
    note("centred", [&] { desk.command("workspace-centre").trigger(); });
    note("fitted", [&] { desk.command("workspace-fit").trigger(); });
    note("fitted by the page", [&] { emit panel.workspace().fitPressed(); });
    note("its axes", [&] { desk.command("workspace-axes").trigger(); });
    note("it drifts", [&] {
        Reach reach = desk.document.scene().reach;
        reach.mode = ReachMode::Drift;
        emit panel.workspace().reachChosen(reach, newGesture());
        desk.until([&] { return desk.window->publisher().world() && !desk.window->publisher().working(); });
    });
    note("impossible", [&] {
        Workspace none;
        none.scale = 0;
        emit panel.workspace().edited(none);
    });
    note("shown", [&] { desk.command("device-panel").trigger(); });
    const auto kept = rememberedSettings(kArm);
    COMPARE_SHOWN(desk.effects->text(), "devices-lie");
    COMPARE_SHOWN(states.text(), "devices-lie-pages");
    QCOMPARE(kept.stopButton, 1U);
    QVERIFY(kept.grasped);
    QCOMPARE_GT(kept.workspace.scale, 3); // what was impossible is not kept
    testing::adopt(desk.document, Scene());
    desk.command("workspace-fit").trigger();
    COMPARE_NEAR(rememberedSettings(kArm).workspace.offset, Vec3(0, 0, 0), 1e-12, "m");
    QCOMPARE_EQ(rememberedSettings(kArm).workspace.scale, kept.workspace.scale);
    QCOMPARE_EQ(desk.link().stop().buttons, 1U);
}

void TestLedDevices::handsBeside() {
    Desk desk;
    desk.arm->go = 3;
    desk.note("the simulated one beside itself", [&] {
        desk.choose("Simulated hand");
        desk.command("hand-add").trigger();
    });
    desk.note("an arm", [&] {
        desk.choose("Example arm");
        desk.command("device-connect").trigger();
        desk.ready(kArm);
    });
    desk.note("the mouse beside it", [&] {
        desk.choose("Simulated hand");
        desk.command("hand-add").trigger();
        desk.until([&] { return desk.link().hands().count() == 2; });
    });
    desk.note("the next", [&] { desk.command("hand-next").trigger(); });
    desk.note("removed", [&] { desk.command("hand-remove").trigger(); });
    desk.note("the other arm beside it", [&] {
        desk.choose("Other arm");
        desk.command("hand-add").trigger();
        desk.ready(kOther);
    });
    desk.note("the next", [&] { desk.command("hand-next").trigger(); });
    desk.note("it stops by a button", [&] { emit desk.panel().live().stopButtonChosen(4); });
    desk.note("and the next", [&] { desk.command("hand-next").trigger(); });
    desk.note("the other one is unplugged", [&] {
        desk.other->plugged = false;
        desk.until([&] { return desk.link().hands().count() == 1; });
    });
    desk.note("and comes back", [&] {
        desk.other->plugged = true;
        desk.seen([&] { return desk.link().uses(kOther) && !desk.link().preparing(); });
    });
    QCOMPARE_EQ(desk.link().stop(1).buttons, 4U);
    desk.note("the first is unplugged", [&] {
        desk.arm->plugged = false;
        desk.until([&] { return desk.link().lost(); });
    });
    COMPARE_SHOWN(desk.effects->text(), "devices-beside");
    COMPARE_SHOWN(desk.hands, "devices-beside-hands");
}

TACTUM_GUI_TEST(TestLedDevices)

} // namespace test_led_devices

#include "test_led_devices.moc"
