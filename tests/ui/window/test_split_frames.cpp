// What the panes of a divided view show of the model in any size, where they look from at first, and how each
// of them is drawn.
#include <algorithm>
#include <cmath>

#include <QAction>
#include <QSettings>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/divided_window.h"
#include "ui/view/scene_view.h"

namespace test_split_frames {

using namespace tactum;

namespace {

constexpr double kMost = 0.99; ///< of a picture that is filled

/// The part of the picture that the cube takes, of the side that it fills more of; above 1 it is cut off.
double filled(const ViewCamera& camera) {
    double most = 0;
    for (unsigned i = 0; i < 8; ++i) {
        const auto at =
            camera.project({i & 1 ? kHalf : -kHalf, i & 2 ? kHalf : -kHalf, i & 4 ? kHalf : -kHalf});
        if (!at) return 2;
        most = std::max({most, std::abs(2 * at->x() / camera.size.width() - 1),
                         std::abs(2 * at->y() / camera.size.height() - 1)});
    }
    return most;
}

} // namespace

class TestSplitFrames : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        unfoldPlots(); // panes in which the finger has room beside the model
    }
    void cleanup() { QSettings().clear(); }

    void aViewIsSeenWholeInHalfTheWidthAndComesBack_data();
    void aViewIsSeenWholeInHalfTheWidthAndComesBack();
    void aWindowOfAnotherSizeShowsAllOfTheModel();
    void anotherDocumentBeginsWithThePlans();
    void whatComesInIsSeenInEveryPane();
    void theProjectionIsThatOfTheActivePane();
    void aDoubleClickOnALineMakesItsPanesEqual();
};

void TestSplitFrames::aViewIsSeenWholeInHalfTheWidthAndComesBack_data() {
    QTest::addColumn<bool>("turned");
    QTest::addColumn<double>("nearer");
    QTest::newRow("as it was opened") << false << 1.0;
    QTest::newRow("turned") << true << 1.0;
    QTest::newRow("turned, and from farther away") << true << 1.3;
}

void TestSplitFrames::aViewIsSeenWholeInHalfTheWidthAndComesBack() {
    QFETCH(bool, turned);
    QFETCH(double, nearer);
    Divided divided(kNoKey, {700, 800});
    SceneView& view = divided.view();
    if (turned) divided.orbit(view.rect().center(), {60, 30});
    view.moveCamera(0, 0, nearer);
    const ViewCamera before = view.camera();
    QCOMPARE_LT(filled(before), kMost);
    divided.press(Qt::Key_2);
    QCOMPARE_LT(filled(view.cameraOf(0)), kMost);
    QCOMPARE_LT(filled(view.cameraOf(1)), kMost);
    QCOMPARE_GT(filled(view.cameraOf(0)), 0.6 / nearer); // and no smaller than it must be
    // Whoever turns it meanwhile keeps where he looks from.
    divided.press(Qt::Key_1);
    QVERIFY(same(view.camera(), before));
    // Nor does the projection cut it off.
    divided.press(Qt::Key_5, Qt::ControlModifier);
    QVERIFY(view.camera().parallel);
    QCOMPARE_LT(filled(view.camera()), kMost);
    divided.press(Qt::Key_5, Qt::ControlModifier);
    QVERIFY(same(view.camera(), before));
    divided.press(Qt::Key_2);
    divided.orbit(divided.pane(0).center(), {30, 0});
    const double yaw = view.cameraOf(0).yaw;
    divided.press(Qt::Key_1);
    QCOMPARE(view.camera().yaw, yaw);
}

void TestSplitFrames::aWindowOfAnotherSizeShowsAllOfTheModel() {
    Divided divided(Qt::Key_Q, {1200, 800});
    const std::vector<ViewCamera> before = divided.cameras();
    for (const QSize size : {QSize(800, 800), QSize(1200, 560), QSize(1600, 950)}) {
        divided.program.window->resize(size);
        divided.program.frames(3);
        for (std::size_t i = 0; i < 4; ++i) {
            const double part = filled(divided.view().cameraOf(i));
            QVERIFY2(part > 0.6 && part < kMost, qPrintable(QStringLiteral("%1: %2").arg(i).arg(part)));
        }
    }
    divided.program.window->resize(1200, 800);
    divided.program.frames(3);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(same(divided.cameras()[i], before[i]));
}

void TestSplitFrames::anotherDocumentBeginsWithThePlans() {
    Divided divided;
    SceneView& view = divided.view();
    const std::vector<ViewCamera> first = divided.cameras();
    for (std::size_t i = 0; i < 4; ++i) {
        divided.orbit(divided.pane(i).center(), {40, 24});
        divided.program.wheel(divided.pane(i).center(), 3);
    }
    const QTemporaryDir other;
    QVERIFY(divided.program.open(writeCube(other)));
    divided.program.frames(2);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY2(same(divided.cameras()[i], first[i]), qPrintable(QString::number(i)));
    // And the finger is where it is seen from there.
    const auto finger = view.camera().project(view.handGoal());
    QVERIFY(finger && QRectF({0, 0}, view.camera().size).contains(*finger));
    QVERIFY(!view.surfaceAt(view.panes()[view.activePane()].topLeft() + *finger));
}

// It is in the picture of the own view already, and not in the one from the front.
void TestSplitFrames::whatComesInIsSeenInEveryPane() {
    Divided divided;
    divided.program.wheel(divided.pane(kFrontPane).center(), 8);
    QCOMPARE_GT(filled(divided.cameras()[kFrontPane]), 1);
    divided.program.moveTo(divided.pane(kOwnPane).center());
    const std::size_t before = divided.program.document.scene().objects.size();
    divided.program.command("add-box").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(divided.program.document.scene().objects.size(), before + 1, kPatience);
    for (std::size_t i = 0; i < 4; ++i)
        QTRY_COMPARE_LT_WITH_TIMEOUT(filled(divided.cameras()[i]), 1, kPatience);
}

void TestSplitFrames::theProjectionIsThatOfTheActivePane() {
    {
        Divided divided;
        QAction& command = divided.program.command("parallel");
        const auto parallel = [&] {
            std::vector<bool> all;
            for (const ViewCamera& camera : divided.cameras())
                all.push_back(camera.parallel);
            return all;
        };
        QCOMPARE(parallel(), (std::vector{true, false, true, true}));
        divided.program.moveTo(divided.pane(kFrontPane).center());
        QVERIFY(command.isChecked()); // as that pane is
        divided.press(Qt::Key_5, Qt::ControlModifier);
        QCOMPARE(parallel(), (std::vector{true, false, false, true}));
        QVERIFY(!command.isChecked());
        divided.program.moveTo(divided.pane(kOwnPane).center());
        divided.press(Qt::Key_5, Qt::ControlModifier);
        QCOMPARE(parallel(), (std::vector{true, true, false, true}));
        divided.program.moveTo(divided.pane(kFrontPane).center());
        QVERIFY(!command.isChecked());
        divided.press(Qt::Key_1);
        QVERIFY(command.isChecked() && divided.view().camera().parallel);
    }
    // The own view is so the next day, and the plans are what they were.
    Divided again;
    QVERIFY(again.program.command("parallel").isChecked());
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(again.cameras()[i].parallel);
}

void TestSplitFrames::aDoubleClickOnALineMakesItsPanesEqual() {
    Divided divided;
    SceneView& view = divided.view();
    const auto crossing = [&] { return divided.pane(kTopPane).bottomRight() + QPoint(1, 1); };
    const auto doubleClick = [&](QPoint at) {
        QTest::mouseDClick(divided.program.window->windowHandle(), Qt::LeftButton, {},
                           view.mapTo(divided.program.window.get(), at));
        divided.program.frames(2);
    };
    divided.drag(crossing(), crossing() + QPoint(-90, 50));
    const double across = view.division().y();
    QCOMPARE_GT(across, 0.52);
    doubleClick({crossing().x(), 20});
    QCOMPARE(view.division(), QPointF(0.5, across));
    doubleClick(crossing());
    QCOMPARE(view.division(), QPointF(0.5, 0.5));
    QCOMPARE(QSettings().value(QStringLiteral("view/split-at")).toPointF(), QPointF(0.5, 0.5));
    // Beside them it does what it does in any view.
    divided.drag(crossing(), crossing() + QPoint(-90, 50));
    doubleClick(divided.pane(kTopPane).center());
    QCOMPARE_LT(view.division().x(), 0.48);
}

TACTUM_GUI_TEST(TestSplitFrames)

} // namespace test_split_frames

#include "test_split_frames.moc"
