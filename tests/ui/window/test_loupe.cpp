// The loupe over the view, as a person meets it: command, press, wheel, and back the next day.
#include <QAction>
#include <QSettings>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/divided_window.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/loupe.h"
#include "ui/widgets/notice_bar.h"

namespace test_loupe {

using namespace tactum;

namespace {

struct Opened {
    Opened() {
        if (!program.open(writeCube(folder))) qFatal("the cube cannot be opened");
    }
    Loupe* loupe() { return program.window->findChild<Loupe*>(); }
    /// Where it is in the view.
    QRect place() {
        return {loupe()->mapTo(program.window.get(), QPoint()) -
                    program.window->view().mapTo(program.window.get(), QPoint()),
                loupe()->size()};
    }
    bool isSeen() { return loupe() && loupe()->isVisible(); }
    void touch(QPoint at) {
        program.press(at);
        if (!test::waitFor([&] { return program.touch().contacts > 0 && isSeen(); }))
            qFatal("there is no loupe: %s", qPrintable(state()));
    }
    /// What a loupe waits for, in words.
    QString state() {
        const auto seen = program.window->view().camera().project(program.finger());
        const QPointF finger = seen.value_or(QPointF(-1, -1));
        return QStringLiteral("%1 contacts, the finger at %2, %3 of %4 x %5; the loupe is %6; said: %7")
            .arg(program.touch().contacts)
            .arg(finger.x())
            .arg(finger.y())
            .arg(program.window->view().width())
            .arg(program.window->view().height())
            .arg(!loupe()               ? "not there"
                 : loupe()->isVisible() ? "seen"
                                        : "hidden")
            .arg(program.window->findChild<NoticeBar*>()->text());
    }
    void wheel(int notches) {
        for (int i = 0; i < std::abs(notches); ++i) {
            const QPoint at = loupe()->rect().center();
            QWheelEvent event(at, loupe()->mapToGlobal(at), {}, {0, notches > 0 ? 120 : -120}, {}, {},
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(loupe(), &event);
        }
    }
    QString line() { return loupe()->accessibleDescription(); }

    QTemporaryDir folder;
    TouchedWindow program{QSize(1200, 960)}; // so high that a notice of several lines leaves room for two
};

} // namespace

class TestLoupe : public QObject {
    Q_OBJECT
public:
    static void initMain() { prepareProcess(); }

private slots:
    void initTestCase() {
        QVERIFY(settings_.isValid());
        useSettingsIn(settings_.path());
    }
    void cleanup() { QSettings().clear(); }

    void itIsNotThereUntilItIsWanted() {
        Opened opened;
        const QPoint centre = opened.program.centre();
        opened.program.press(centre);
        QTRY_VERIFY_WITH_TIMEOUT(opened.program.touch().contacts > 0, kPatience);
        opened.program.frames(5);
        QVERIFY(!opened.loupe());
        opened.program.command("loupe").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(opened.isSeen(), kPatience);
        QCOMPARE(opened.loupe()->accessibleName(), QStringLiteral("Loupe"));
        opened.program.command("loupe").trigger();
        QVERIFY(!opened.isSeen());
        opened.program.release(centre);
    }

    void itGoesAfterTheTouchAndComesWithTheNext() {
        Opened opened;
        opened.program.command("loupe").trigger();
        opened.program.frames(2);
        QVERIFY(!opened.loupe());
        const QPoint centre = opened.program.centre();
        opened.touch(centre);
        opened.program.release(centre);
        QTRY_VERIFY_WITH_TIMEOUT(opened.program.touch().contacts == 0, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!opened.isSeen(), kPatience);
        opened.touch(centre);
        opened.program.release(centre);
    }

    void itFollowsTheFinger() {
        Opened opened;
        opened.program.command("loupe").trigger();
        const QPoint centre = opened.program.centre();
        opened.touch(centre);
        QVERIFY(opened.program.atRest());
        opened.program.frames(10);
        const QImage before = opened.loupe()->picture();
        const QPoint edge = opened.program.window->view().camera().project({0.04, 0.03, 0.05})->toPoint();
        opened.program.moveTo(centre + (edge - centre) / 2);
        opened.program.moveTo(edge);
        QTRY_VERIFY_WITH_TIMEOUT(opened.program.touch().proxy.x() > 0.03, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(opened.loupe()->picture() != before, kPatience);
        opened.program.release(edge);
    }

    void theWheelChangesTheFactorBetweenItsBounds() {
        Opened opened;
        opened.program.command("loupe").trigger();
        const QPoint centre = opened.program.centre();
        opened.touch(centre);
        QCOMPARE(opened.line(), QStringLiteral("5 times as large"));
        opened.wheel(1);
        QCOMPARE(opened.line(), QStringLiteral("5.5 times as large"));
        const ViewCamera camera = opened.program.window->view().camera();
        opened.wheel(30);
        QCOMPARE(opened.line(), QStringLiteral("10 times as large"));
        opened.wheel(-30);
        QCOMPARE(opened.line(), QStringLiteral("3 times as large"));
        QCOMPARE(opened.program.window->view().camera().distance, camera.distance); // the view does not zoom
        opened.program.release(centre);
    }

    void itIsRememberedWithItsFactor() {
        {
            Opened opened;
            QVERIFY(!opened.program.command("loupe").isChecked());
            opened.program.command("loupe").trigger();
            const QPoint centre = opened.program.centre();
            opened.touch(centre);
            opened.wheel(4);
            opened.program.release(centre);
        }
        Opened again;
        QVERIFY(again.program.command("loupe").isChecked());
        const QPoint centre = again.program.centre();
        again.touch(centre);
        QCOMPARE(again.line(), QStringLiteral("7 times as large"));
        again.program.release(centre);
    }

    void itMakesRoomForTheContactTheAxesAndTheNotices() {
        Opened opened;
        opened.program.command("loupe").trigger();
        SceneView& view = opened.program.window->view();
        view.flyTo(Vec3(-0.02, 0, 0), 0.02, Vec3::UnitZ()); // the front fills the view
        QTRY_VERIFY_WITH_TIMEOUT(view.surfaceAt({view.width() - 30.0, view.height() - 60.0}), kPatience);
        opened.program.frames(30);
        const QRect axes(view.width() - 100, 0, 100, 100);
        for (const QPoint at :
             {QPoint(view.width() - 60, view.height() - 60), QPoint(view.width() - 60, 170)}) {
            opened.touch(at);
            QTRY_VERIFY_WITH_TIMEOUT(
                !opened.place().contains(view.camera().project(opened.program.touch().proxy)->toPoint()),
                kPatience);
            opened.program.window->findChild<NoticeBar*>()->showNote(QStringLiteral("said over the view"));
            opened.program.frames(5);
            QVERIFY(!opened.place().intersects(axes));
            QVERIFY(view.rect().contains(opened.place()));
            QCOMPARE_GE(opened.place().height(), 96);
            auto* notice = opened.program.window->findChild<NoticeBar*>();
            QVERIFY(!opened.program.placeOf(*opened.loupe()).intersects(opened.program.placeOf(*notice)));
            opened.program.release(at);
            QTRY_VERIFY_WITH_TIMEOUT(!opened.isSeen(), kPatience);
        }
    }

    // It may stand over any pane: it says which one it shows from nearby.
    void inADividedViewItNamesItsPane() {
        Divided divided;
        divided.program.command("loupe").trigger();
        const auto line = [&] {
            const auto* loupe = divided.program.window->findChild<Loupe*>();
            return loupe && loupe->isVisible() ? loupe->accessibleDescription() : QString();
        };
        const auto touch = [&](std::size_t pane) {
            const QPoint at = divided.pane(pane).center();
            divided.program.press(at);
            [&] { QTRY_VERIFY_WITH_TIMEOUT(!line().isEmpty(), kPatience); }();
            divided.program.frames(10);
            const QString said = line();
            divided.program.release(at);
            [&] { QTRY_COMPARE_WITH_TIMEOUT(line(), QString(), kPatience); }();
            return said;
        };
        QCOMPARE(touch(kFrontPane), QStringLiteral("Front, parallel: 5 times as large"));
        QCOMPARE(touch(kOwnPane), QStringLiteral("Own view: 5 times as large"));
        divided.press(Qt::Key_1);
        QCOMPARE(touch(0), QStringLiteral("5 times as large"));
    }

private:
    QTemporaryDir settings_;
};

TACTUM_GUI_TEST(TestLoupe)

} // namespace test_loupe

#include "test_loupe.moc"
