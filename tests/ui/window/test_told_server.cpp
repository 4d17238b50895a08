// What the window makes of a haptic server that tells what a test says: scenes that arrive, the pen, what was
// refused. Wrong itself if a server told something else: the states are those of SharedScene, each alone.
#include <queue>

#include <QPushButton>
#include <QTest>
#include <QUndoStack>

#include "core/runtime/shared_scene.h"
#include "tests/support/as_shown.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/told_window.h"
#include "ui/panels/connection_bar.h"
#include "ui/panels/device_connect.h"
#include "ui/panels/device_panel.h"
#include "ui/widgets/notice_bar.h"

namespace test_told_server {

using namespace tactum;
using tactum::testing::knownScene;

namespace {

class ToldServer final : public SharedScene {
public:
    std::optional<Arrived> next;
    std::optional<std::string> no, force, asks;
    bool pen = false;
    std::string holder, asker;
    std::size_t clients = 1;
    int penWishes = 0;
    std::vector<std::string> penGiven;

    std::string place() const override { return "desk:7"; }
    std::optional<Arrived> arrived() override { return std::exchange(next, std::nullopt); }
    std::optional<std::string> refused() override { return std::exchange(no, std::nullopt); }
    std::optional<std::string> forceSaid() override { return std::exchange(force, std::nullopt); }
    bool holdsPen() const override { return pen; }
    std::string penHolder() const override { return holder; }
    void askForPen() override { ++penWishes; }
    std::optional<std::string> penAskedBy() override { return std::exchange(asks, std::nullopt); }
    std::string penAsker() const override { return asker; }
    void givePen(const std::string& to) override { penGiven.push_back(to); }
    std::size_t attending() const override { return clients; }
};

/// A window at a server, and what differs with each thing that it tells.
struct AtServer {
    AtServer() {
        told.window->setShared(server);
        told.frames(3);
    }
    QPushButton* button(const QString& text) {
        const auto& notice = *told.window->findChild<NoticeBar*>();
        if (notice.isHidden()) return nullptr;
        for (auto* each : notice.findChildren<QPushButton*>())
            if (!each->isHidden() && each->text() == text) return each;
        return nullptr;
    }
    void press(const char* text) {
        auto* found = button(QLatin1String(text));
        if (!found) qFatal("no button %s", text);
        found->click();
    }
    QString standing() {
        const auto& bar = *told.window->findChild<ConnectionBar*>();
        QStringList offers;
        for (const char* each : {"Let them", "Send mine"})
            if (button(QLatin1String(each))) offers << QLatin1String(each);
        return QStringLiteral("%1 (%2)%3, offers: %4; file %5, %6 steps, at %7 \"%8\"\n")
            .arg(bar.text(), bar.property("severity").toString(),
                 bar.findChild<QPushButton*>(QStringLiteral("connection-ask"))->isHidden() ? "" : ", may ask",
                 offers.join(u','), QString::fromStdString(told.document.path().filename().string()))
            .arg(told.document.history().count())
            .arg(told.document.history().index())
            .arg(told.document.history().undoText());
    }
    void note(const char* words, const std::function<void()>& act) {
        effects.note(QLatin1String(words), [&] {
            act();
            told.frames(3);
            stands += QStringLiteral("%1: ").arg(QLatin1String(words)) + standing();
        });
    }
    /// Without undoing it afterwards.
    void go(const char* words, const std::function<void()>& act) {
        act();
        told.frames(3);
        stands += QStringLiteral("%1: ").arg(QLatin1String(words)) + standing() + QStringLiteral("  says: ") +
                  told.window->findChild<NoticeBar*>()->text() + u'\n';
    }
    void arrive(SharedScene::Arrival why, const Scene& scene) { server.next = {why, scene}; }

    ToldServer server; // outlives the window
    ToldWindow told{1, [](test::ToldEngine& engine) { engine.of[0].device.name = "Arm"; }};
    WindowEffects effects{told.effects()};
    QString stands;
};

/// Of the same shapes each time.
const Scene& served() {
    static const Scene scene = knownScene();
    return scene;
}

Scene stiffer(double stiffness) {
    Scene scene = served();
    scene.objects[0].surfaces[0].material.stiffness = stiffness;
    return scene;
}

} // namespace

class TestToldServer : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() { test::speakEnglish(); }
    void init() { useSettingsIn(folders_.next()); }

    void scenesArrive();
    void whatIsRefusedIsTakenBack();
    void thePenGoesRound();
};

void TestToldServer::scenesArrive() {
    AtServer at;
    using Arrival = SharedScene::Arrival;
    at.go("the first", [&] { at.arrive(Arrival::Begun, served()); });
    at.told.catchUp();
    at.note("changed by nobody", [&] { at.arrive(Arrival::Changed, stiffer(700)); });
    at.server.holder = "Ada";
    at.note("changed by somebody", [&] { at.arrive(Arrival::Changed, stiffer(800)); });
    at.note("another one", [&] { at.arrive(Arrival::Another, stiffer(900)); });
    at.go("another one", [&] { at.arrive(Arrival::Another, stiffer(900)); });
    at.go("one's own is sent", [&] { at.press("Send mine"); });
    at.note("the connection is lost", [&] { at.told.engine.runs = false; });
    at.note("and there again", [&] { at.told.engine.runs = true; });
    at.note("somebody switches forces", [&] { at.server.force = "Ada has switched the force off"; });
    at.note("forces are on", [&] { at.told.engine.setAllArmed(true); });
    at.note("an order is refused", [&] { at.server.no = "another client has the pen"; });
    COMPARE_SHOWN(at.effects.text(), "server-scenes");
    COMPARE_SHOWN(at.stands, "server-scenes-stand");
}

// What the server has is what a step of the history led to, so the window goes to that step; else it is one
// more.
void TestToldServer::whatIsRefusedIsTakenBack() {
    AtServer at;
    using Arrival = SharedScene::Arrival;
    at.go("the first", [&] { at.arrive(Arrival::Begun, served()); });
    at.told.catchUp();
    Document& document = at.told.document;
    const auto edit = [&](double stiffness) {
        document.replaceScene(QStringLiteral("Edit"), stiffer(stiffness));
    };
    at.go("three edits", [&] {
        for (const double each : {510.0, 520.0, 530.0})
            edit(each);
    });
    at.go("what is there already", [&] { at.arrive(Arrival::Refused, stiffer(530)); });
    at.go("the last is refused", [&] { at.arrive(Arrival::Refused, stiffer(520)); });
    at.go("it is done again", [&] { document.history().redo(); });
    at.go("two are refused", [&] { at.arrive(Arrival::Refused, stiffer(510)); });
    at.go("all are", [&] { at.arrive(Arrival::Refused, served()); });
    at.go("two are redone", [&] { document.history().setIndex(2); });
    at.go("that it was undone is refused", [&] { at.arrive(Arrival::Refused, stiffer(530)); });
    at.go("what nobody had here", [&] { at.arrive(Arrival::Refused, stiffer(990)); });
    QCOMPARE(document.scene(), stiffer(990));
    QCOMPARE(document.history().undoText(), QStringLiteral("As at desk:7"));
    COMPARE_SHOWN(at.stands, "server-refused");
}

void TestToldServer::thePenGoesRound() {
    AtServer at;
    at.go("the first", [&] { at.arrive(SharedScene::Arrival::Begun, served()); });
    at.told.catchUp();
    at.note("nobody has it", [] {});
    at.note("somebody else has it", [&] {
        at.server.holder = "Ada";
        at.server.clients = 3;
    });
    at.note("it is asked for", [&] { emit at.told.window->findChild<ConnectionBar*>()->penWanted(); });
    QCOMPARE(at.server.penWishes, 1);
    at.note("it is had", [&] {
        at.server.pen = true;
        at.server.holder = "me";
    });
    const auto ask = [&] {
        at.server.asks = "Ada";
        at.server.asker = "Ada";
    };
    at.note("somebody asks", ask);
    at.note("and goes", [&] { at.server.asker.clear(); });
    at.go("asks again", ask);
    at.go("goes again", [&] { at.server.asker.clear(); });
    at.go("asks once more", ask);
    at.go("is let", [&] { at.press("Let them"); });
    QCOMPARE(at.server.penGiven, std::vector<std::string>{"Ada"});
    const auto& panel = *at.told.window->findChild<DevicePanel*>();
    COMPARE_SHOWN(at.effects.text(), "server-pen");
    COMPARE_SHOWN(at.stands, "server-pen-stand");
    const auto* line = panel.findChild<QLabel*>(QStringLiteral("device-at-server"));
    QVERIFY(line && !line->isHidden());
    const QString said = line->text();
    at.told.engine.runs = false;
    at.told.frames(3);
    COMPARE_SHOWN(said + u'\n' + line->text(), "server-device");
}

TACTUM_GUI_TEST(TestToldServer)

} // namespace test_told_server

#include "test_told_server.moc"
