// The divided view, as a person meets it: by key and mouse, in each pane, and back the next day.
#include <algorithm>
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QSettings>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/divided_window.h"
#include "tests/ui/window/file_dialogs.h"
#include "ui/base/theme.h"
#include "ui/view/scene_view.h"

namespace test_split {

using namespace tactum;

namespace {

/// Pixels of a part of two pictures that are not the same; the part in logical pixels.
int different(const QImage& a, const QImage& b, const QRect& part, double ratio) {
    const QRect pixels(part.topLeft() * ratio, part.size() * ratio);
    int count = 0;
    for (int y = std::max(0, pixels.top()); y <= std::min(pixels.bottom(), a.height() - 1); ++y)
        for (int x = std::max(0, pixels.left()); x <= std::min(pixels.right(), a.width() - 1); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

} // namespace

class TestSplit : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }
    void cleanup() { QSettings().clear(); }

    void aKeyDividesItAndGoesBackToTheSamePicture();
    void thePanesAreThoseOfPlans();
    void theActivePaneIsSeen();
    void aPaneTurnsAlone();
    void theWheelZoomsWhereThePointerIs();
    void aPressTouchesWhatIsUnderThePointerThere();
    void aClickSelectsThere();
    void theTouchIsSeenInEachPane();
    void aTouchDrawsNoModelAnew();
    void viewKeysActWhereThePointerIsAndMenusWhereItWasUsed();
    void aKeptCameraComesToTheActivePane();
    void theLinesAreDraggedAndComeBack();
    void itIsRemembered();
    void panesFillWindowsOfAnySize();
    void aRegionIsDrawnInItsPane();
};

void TestSplit::aKeyDividesItAndGoesBackToTheSamePicture() {
    Divided divided(kNoKey);
    divided.view().moveCamera(0.3, 0.1, 0.9);
    const ViewCamera camera = divided.view().camera();
    const QImage before = divided.view().grabPicture();
    const int actors = divided.view().actorCount();
    QCOMPARE(divided.count(), std::size_t(1));
    for (const auto& [key, panes] :
         {std::pair(Qt::Key_2, 2), {Qt::Key_3, 2}, {Qt::Key_4, 4}, {Qt::Key_1, 1}, {Qt::Key_Q, 4}}) {
        divided.press(key);
        QCOMPARE(divided.count(), std::size_t(panes));
    }
    QVERIFY(divided.view().grabPicture() != before);
    QCOMPARE(divided.view().actorCount(), actors); // the model is there once
    divided.press(Qt::Key_Q);                      // once more is back
    QCOMPARE(divided.count(), std::size_t(1));
    QVERIFY(same(divided.view().camera(), camera));
    QCOMPARE(different(divided.view().grabPicture(), before, divided.view().rect(),
                       divided.view().devicePixelRatioF()),
             0);
}

void TestSplit::thePanesAreThoseOfPlans() {
    Divided divided;
    const std::vector<ViewCamera> all = divided.cameras();
    COMPARE_NEAR(all[kTopPane].forward(), Vec3(-Vec3::UnitY()), 1e-9, "");
    COMPARE_NEAR(all[kFrontPane].forward(), Vec3(-Vec3::UnitZ()), 1e-9, "");
    COMPARE_NEAR(all[kRightPane].forward(), Vec3(-Vec3::UnitX()), 1e-9, "");
    QVERIFY(all[kTopPane].parallel && all[kFrontPane].parallel && all[kRightPane].parallel);
    QVERIFY(!all[kOwnPane].parallel);
    QCOMPARE(divided.nameAt(divided.seen(kTopPane, {0, kHalf, 0})), QByteArray("top"));
    QCOMPARE(divided.nameAt(divided.seen(kFrontPane, {0, 0, kHalf})), QByteArray("front"));
    QCOMPARE(divided.nameAt(divided.seen(kRightPane, {kHalf, 0, 0})), QByteArray("right"));
}

// A frame about it, of the accent's colour, and its name on that.
void TestSplit::theActivePaneIsSeen() {
    Divided divided;
    for (const bool dark : {true, false}) {
        divided.view().setTheme(dark);
        const QColor accent = themeFor(dark).accent;
        for (std::size_t active = 0; active < 4; ++active) {
            divided.program.moveTo(divided.pane(active).center());
            const QImage picture = divided.view().grabPicture();
            const double ratio = divided.view().devicePixelRatioF();
            for (std::size_t i = 0; i < 4; ++i) {
                const QRect pane = divided.pane(i);
                for (const QPoint& edge :
                     {QPoint(pane.left() + 1, pane.center().y()), QPoint(pane.right() - 1, pane.center().y()),
                      QPoint(pane.center().x(), pane.bottom() - 1), pane.topLeft() + QPoint(11, 13)})
                    QCOMPARE(QColor(picture.pixel(edge * ratio)) == accent, i == active);
            }
        }
        const QRect last = divided.pane(3);
        const QPoint edge(last.left() + 1, last.center().y());
        const QImage toKeep = divided.view().grabWithoutHandles();
        QVERIFY(QColor(toKeep.pixel(edge * divided.view().devicePixelRatioF())) != accent);
    }
}

void TestSplit::aPaneTurnsAlone() {
    Divided divided;
    for (std::size_t turned = 0; turned < 4; ++turned) {
        const std::vector<ViewCamera> before = divided.cameras();
        divided.orbit(divided.pane(turned).center(), {40, 24});
        const std::vector<ViewCamera> after = divided.cameras();
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(same(before[i], after[i]), i != turned);
        // As much as in a view of that size: half a turn for the shorter side.
        const double perPixel = EIGEN_PI / std::min(after[turned].size.width(), after[turned].size.height());
        COMPARE_NEAR(std::remainder(after[turned].yaw - before[turned].yaw, 2 * EIGEN_PI), -40 * perPixel,
                     1e-9, "rad");
        QCOMPARE(divided.view().activePane(), turned);
    }
    // A drag that leaves its pane goes on turning that one.
    const std::vector<ViewCamera> before = divided.cameras();
    const QPoint over = divided.pane(kFrontPane).center() - divided.pane(kRightPane).center();
    divided.orbit(divided.pane(kRightPane).center(), over);
    for (std::size_t i = 0; i < 4; ++i)
        QCOMPARE(same(before[i], divided.cameras()[i]), i != kRightPane);
}

void TestSplit::theWheelZoomsWhereThePointerIs() {
    Divided divided;
    const std::vector<ViewCamera> before = divided.cameras();
    const Vec3 corner(kHalf, 0.04, 0.02);
    const QPoint at = divided.seen(kRightPane, corner) - QPoint(4, 0);
    const Vec3 under = before[kRightPane].pointAtDepthOf(corner, at - divided.pane(kRightPane).topLeft());
    divided.program.wheel(at, 2);
    const std::vector<ViewCamera> after = divided.cameras();
    QCOMPARE_LT(after[kRightPane].distance, 0.8 * before[kRightPane].distance);
    QVERIFY(same(before[kOwnPane], after[kOwnPane]) && same(before[kTopPane], after[kTopPane]));
    const QPoint then = divided.seen(kRightPane, under);
    QCOMPARE_LE((then - at).manhattanLength(), 1); // what is under the pointer stays there
    divided.press(Qt::Key_Home, {});
    QVERIFY(same(divided.cameras()[kRightPane], before[kRightPane]));
}

void TestSplit::aPressTouchesWhatIsUnderThePointerThere() {
    Divided divided(Qt::Key_2);
    QVERIFY(divided.program.fullForce());
    QCOMPARE(divided.count(), std::size_t(2));
    const Vec3 place(kHalf, 0.01, -0.02);
    const QPoint at = divided.seen(1, place);
    divided.program.moveTo(at);
    divided.program.press(at);
    QTRY_COMPARE_GT_WITH_TIMEOUT(divided.program.touch().contacts, 0, kPatience);
    QVERIFY(divided.program.atRest());
    const HapticOutput touch = divided.program.touch();
    COMPARE_NEAR(touch.contact[0].normal, Vec3(Vec3::UnitX()), 1e-6, "");
    QCOMPARE_GT(touch.force.x(), 0.1);
    const double pixel = divided.view().cameraOf(1).pixelSize(place);
    COMPARE_NEAR(touch.contact[0].point, place, 2 * pixel, "m");
    // A stroke goes along the surface there: to the right in the pane is away from the front.
    divided.program.moveTo(at + QPoint(10, 0));
    divided.program.moveTo(at + QPoint(20, 0));
    QTRY_COMPARE_LT_WITH_TIMEOUT(divided.program.touch().proxy.z(), place.z() - 12 * pixel, kPatience);
    divided.program.release(at + QPoint(20, 0));
    QTRY_COMPARE_WITH_TIMEOUT(divided.program.touch().contacts, 0, kPatience);
}

void TestSplit::aClickSelectsThere() {
    Divided divided;
    divided.program.command("select").trigger();
    const std::pair<std::size_t, Vec3> places[] = {
        {kTopPane, {0.01, kHalf, 0}}, {kRightPane, {kHalf, 0.01, 0}}, {kFrontPane, {0, 0.01, kHalf}}};
    const char* names[] = {"top", "right", "front"};
    for (std::size_t i = 0; i < std::size(places); ++i) {
        divided.click(divided.seen(places[i].first, places[i].second));
        const auto selected = divided.program.document.selection();
        QVERIFY(selected.has_value());
        QCOMPARE(divided.program.document.surface(*selected)->name, std::string(names[i]));
    }
    // Beside the model in its own pane, although the model is there in another one.
    divided.click(divided.pane(kFrontPane).bottomLeft() + QPoint(8, -8));
    QVERIFY(!divided.program.document.selection());
}

void TestSplit::theTouchIsSeenInEachPane() {
    Divided divided;
    const QPoint at = divided.seen(kRightPane, {kHalf, 0.02, 0.02});
    divided.program.press(at);
    QTRY_COMPARE_GT_WITH_TIMEOUT(divided.program.touch().contacts, 0, kPatience);
    QVERIFY(divided.program.atRest());
    divided.program.frames(5);
    const Vec3 proxy = divided.program.touch().proxy;
    const QImage with = divided.view().grabPicture();
    divided.program.command("overlay").trigger();
    const QImage without = divided.view().grabPicture();
    divided.program.command("overlay").trigger();
    for (std::size_t i = 0; i < 4; ++i) {
        QRect about(0, 0, 9, 9);
        about.moveCenter(divided.seen(i, proxy));
        QVERIFY2(divided.pane(i).contains(about), qPrintable(QString::number(i)));
        QCOMPARE_GT(different(with, without, about, divided.view().devicePixelRatioF()), 30);
    }
    divided.program.release(at);
}

// Each pane keeps the picture of the model, in any quality.
void TestSplit::aTouchDrawsNoModelAnew() {
    Divided divided;
    SceneView& view = divided.view();
    const QPoint at = divided.seen(kOwnPane, {0, 0.02, kHalf});
    divided.program.press(at);
    QTRY_COMPARE_GT_WITH_TIMEOUT(divided.program.touch().contacts, 0, kPatience);
    QVERIFY(divided.program.atRest());
    QTRY_VERIFY_WITH_TIMEOUT(view.rests(), kPatience);
    const int before = view.modelPictures();
    const Vec3 proxy = divided.program.touch().proxy;
    for (int i = 1; i <= 10; ++i) {
        divided.program.moveTo(at + QPoint(i, 0));
        divided.program.frames(2);
    }
    QCOMPARE_GT((divided.program.touch().proxy - proxy).norm(), 1e-3);
    QCOMPARE_LE(view.modelPictures(), before + 4); // the first in motion has fewer samples
    divided.program.release(at + QPoint(10, 0));
    QTRY_VERIFY_WITH_TIMEOUT(view.rests(), kPatience);
    // A pane that turns is drawn, the three others are not.
    divided.orbit(divided.pane(kOwnPane).center(), {4, 0});
    divided.program.frames(3);
    const int turned = view.modelPictures();
    for (int i = 0; i < 5; ++i) {
        view.moveCamera(0.01, 0);
        divided.program.frames(2);
    }
    QCOMPARE_GE(view.modelPictures() - turned, 1);
    QCOMPARE_LE(view.modelPictures() - turned, 8);
}

void TestSplit::viewKeysActWhereThePointerIsAndMenusWhereItWasUsed() {
    Divided divided;
    SceneView& view = divided.view();
    divided.program.wheel(divided.pane(kOwnPane).center(), 1);
    const std::vector<ViewCamera> before = divided.cameras();
    divided.program.moveTo(divided.pane(kFrontPane).center());
    QCOMPARE(view.activePane(), kFrontPane);
    divided.press(Qt::Key_7, Qt::KeypadModifier);
    COMPARE_NEAR(divided.cameras()[kFrontPane].pitch, EIGEN_PI / 2, 1e-9, "rad");
    for (const std::size_t other : {kTopPane, kOwnPane, kRightPane})
        QVERIFY(same(divided.cameras()[other], before[other]));
    // The key was the last that was done in the view, and the way to a menu is nothing.
    divided.program.wheel(divided.pane(kRightPane).center(), 1);
    divided.program.moveTo(divided.pane(kTopPane).center());
    QCOMPARE(view.activePane(), kTopPane);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&view, &leave);
    QCOMPARE(view.activePane(), kRightPane);
    divided.program.command("view-front").trigger();
    COMPARE_NEAR(divided.cameras()[kRightPane].yaw, 0.0, 1e-9, "rad");
    QVERIFY(same(divided.cameras()[kTopPane], before[kTopPane]));
}

void TestSplit::aKeptCameraComesToTheActivePane() {
    Divided divided;
    SceneView& view = divided.view();
    divided.orbit(divided.pane(kOwnPane).center(), {30, -20});
    const double yaw = view.camera().yaw;
    answerTextDialog(QStringLiteral("kept"));
    divided.program.command("camera-keep").trigger();
    QCOMPARE(divided.program.document.scene().cameras.size(), std::size_t(1));
    divided.program.moveTo(divided.pane(kRightPane).center());
    const std::vector<ViewCamera> before = divided.cameras();
    divided.press(Qt::Key_1, Qt::AltModifier);
    QTRY_COMPARE_LT_WITH_TIMEOUT(std::abs(divided.cameras()[kRightPane].yaw - yaw), 1e-9, kPatience);
    QVERIFY(same(divided.cameras()[kOwnPane], before[kOwnPane]));
    QVERIFY(!divided.cameras()[kRightPane].parallel); // it is drawn as it was kept
}

void TestSplit::theLinesAreDraggedAndComeBack() {
    QPointF division;
    {
        Divided divided;
        SceneView& view = divided.view();
        const QPoint crossing = divided.pane(kTopPane).bottomRight() + QPoint(1, 1);
        divided.program.moveTo(crossing);
        QCOMPARE(view.cursor().shape(), Qt::SizeAllCursor);
        const std::vector<ViewCamera> before = divided.cameras();
        divided.drag(crossing, crossing + QPoint(-60, 40));
        QCOMPARE_LE(std::abs(divided.pane(kTopPane).right() + 1 - (crossing.x() - 60)), 2);
        QCOMPARE_LE(std::abs(divided.pane(kTopPane).bottom() + 1 - (crossing.y() + 40)), 2);
        COMPARE_NEAR(divided.cameras()[kOwnPane].yaw, before[kOwnPane].yaw, 1e-12, "rad");
        // Only one of them beside the crossing.
        const int width = divided.pane(kTopPane).width();
        const QPoint across(20, divided.pane(kTopPane).height() + 1);
        divided.drag(across, across - QPoint(0, 30));
        QCOMPARE(divided.pane(kTopPane).width(), width);
        division = view.division();
        QCOMPARE_LT(division.x(), 0.49);
    }
    Divided again(kNoKey);
    QCOMPARE(again.count(), std::size_t(4));
    COMPARE_NEAR(again.view().division().x(), division.x(), 1e-9, "");
    COMPARE_NEAR(again.view().division().y(), division.y(), 1e-9, "");
}

void TestSplit::itIsRemembered() {
    { Divided divided(Qt::Key_3); }
    {
        Divided again(kNoKey);
        QCOMPARE(again.count(), std::size_t(2));
        QCOMPARE(again.pane(0).width(), again.view().width());
        QVERIFY(again.program.command("split-rows").isChecked());
        QCOMPARE(again.nameAt(again.seen(1, {kHalf, 0, 0})), QByteArray("right"));
        again.program.command("split-one").trigger();
    }
    Divided last(kNoKey);
    QCOMPARE(last.count(), std::size_t(1));
}

void TestSplit::panesFillWindowsOfAnySize() {
    for (const QSize size : {QSize(800, 500), QSize(1200, 800)}) {
        Divided divided(Qt::Key_Q, size);
        SceneView& view = divided.view();
        for (const QSize next : {size, QSize(1000, 600)}) {
            divided.program.window->resize(next);
            divided.program.frames(3);
            const std::vector<QRect> panes = view.panes();
            QRegion all;
            for (std::size_t i = 0; i < panes.size(); ++i) {
                QVERIFY(!all.intersects(panes[i]) && view.rect().contains(panes[i]));
                QCOMPARE(view.cameraOf(i).size, QSizeF(panes[i].size()));
                all += panes[i];
            }
            QCOMPARE(all.boundingRect(), view.rect());
            // What each of them says is under its middle is what is drawn there.
            const QImage picture = view.grabPicture();
            const double ratio = view.devicePixelRatioF();
            QCOMPARE(picture.size(), (QSizeF(view.size()) * ratio).toSize());
            for (std::size_t i = 0; i < panes.size(); ++i) {
                const QPoint inside = divided.seen(i, {0.02, 0.02, 0.02});
                QVERIFY(view.surfaceAt(inside).has_value());
                const QPoint sky = panes[i].topRight() + QPoint(-4, 4);
                QVERIFY(!view.surfaceAt(sky).has_value());
                QVERIFY(picture.pixel(inside * ratio) != picture.pixel(sky * ratio));
            }
        }
    }
}

void TestSplit::aRegionIsDrawnInItsPane() {
    Divided divided;
    if (divided.program.command("through").isChecked()) divided.program.command("through").trigger();
    const std::pair<std::size_t, Vec3> places[] = {{kFrontPane, {0, 0.01, kHalf}},
                                                   {kRightPane, {kHalf, 0.01, 0}}};
    for (const auto& [pane, middle] : places) {
        divided.program.command("box").trigger();
        const QPoint at = divided.seen(pane, middle);
        divided.drag(at - QPoint(9, 9), at + QPoint(9, 9));
        const std::string name = pane == kFrontPane ? "front" : "right";
        QTRY_VERIFY_WITH_TIMEOUT(
            divided.program.document.selection() &&
                divided.program.document.surface(*divided.program.document.selection())->name == name,
            kPatience);
        QCOMPARE(divided.program.document.selected().size(), std::size_t(1));
    }
}

TACTUM_GUI_TEST(TestSplit)

} // namespace test_split

#include "test_split.moc"
