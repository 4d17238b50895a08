// The first touch from end to end: open a model, press into it with the mouse, feel its friction, change it,
// feel the difference, take it back.
#include <numbers>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/preferences.h"
#include "ui/view/lagging_cursor.h"
#include "ui/view/scene_view.h"

namespace test_first_touch {

using namespace tactum;

namespace {

constexpr double kHalf = 0.05; // m, half an edge of the cube

double tangentialRatio(const HapticOutput& touch) {
    const Vec3 normal = touch.contact[0].normal;
    const double pressing = touch.force.dot(normal);
    return (touch.force - pressing * normal).norm() / pressing;
}

} // namespace

class TestFirstTouch : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::unique_ptr<TouchedWindow> program_;

    void pressIntoTheFront();
    void breakAway(double& ratio);

private slots:
    static void initMain() { prepareProcess(); }
    void init();
    void cleanup() { program_.reset(); }

    void theFingerStartsWhereItIsSeen_data();
    void theFingerStartsWhereItIsSeen();
    void whatIsTouchedIsNamed();
    void proxyStaysOutsideWhileFingerIsInside();
    void frictionTypedIntoTheInspectorIsFeltAndUndone();
    void aPseudoHapticMouseLagsWithTheForce();
    void stopEndsTheForce();
    void whereNothingCanBeTouchedNobodyIsToldTo();
};

void TestFirstTouch::init() {
    useSettingsIn(folder_.path());
    unfoldPlots();
    program_ = std::make_unique<TouchedWindow>();
    QVERIFY(program_->open(writeCube(folder_)));
    program_->window->view().showStandardView(StandardView::Front);
    program_->frames(5);
}

/// A real press in the middle of the view, deeper with the wheel, and time to come to rest.
void TestFirstTouch::pressIntoTheFront() {
    program_->press(program_->centre());
    QTRY_VERIFY_WITH_TIMEOUT(program_->touch().contacts == 1, kPatience);
    program_->frames(60);
    program_->wheel(program_->centre(), 8);
    program_->frames(60);
    // At rest a contact sticks again; on a busy machine the hand takes longer to come to rest.
    QTRY_VERIFY_WITH_TIMEOUT(program_->touch().contacts == 1 && !program_->touch().contact[0].slipping,
                             kPatience);
}

/// Over a rough front the mouse leads the hand as much less far as the force against it says; and the
/// pointer, which was hidden, comes back where it led to.
void TestFirstTouch::aPseudoHapticMouseLagsWithTheForce() {
    Preferences::instance().set(Preferred::Lag, 1);
    const ObjectId cube = program_->document.scene().objects.front().id;
    program_->document.select(SurfaceRef{cube, 4}); // front
    program_->type(QStringLiteral("static-friction"), QStringLiteral("0.5"));
    QTRY_VERIFY_WITH_TIMEOUT(program_->caughtUp(), kPatience);
    pressIntoTheFront();
    SceneView& view = program_->window->view();
    QCOMPARE(view.cursor().shape(), Qt::BlankCursor);
    QSignalSpy goals(&view, &SceneView::handGoalMoved);
    const ViewCamera& camera = view.camera();
    QPoint at = program_->centre();
    const double begin = at.x();
    double expected = begin, slowest = 1; // pixels
    for (int i = 0; i < 80; ++i) {
        program_->frames(4);
        const double push = program_->engine.servo().force.dot(camera.right());
        slowest = std::min(slowest, std::clamp(1 + push / LaggingCursor::kHalt, 0.2, 1.8));
        expected += std::clamp(1 + push / LaggingCursor::kHalt, 0.2, 1.8);
        program_->moveTo(at += QPoint(1, 0));
    }
    QCOMPARE_LT(slowest, 0.8);
    const double led = camera.project(goals.back()[0].value<Vec3>())->x();
    COMPARE_NEAR(led - begin, expected - begin, 0.1 * (expected - begin), "px");
    program_->release(at);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(view.mapFromGlobal(QCursor::pos()).x() - led) < 2, kPatience);
    QVERIFY(view.cursor().shape() != Qt::BlankCursor);
    Preferences::instance().set(Preferred::Lag, 0);
}

/// Strokes sideways, a pixel at a time, until the proxy gives way; the largest ratio until then.
void TestFirstTouch::breakAway(double& ratio) {
    pressIntoTheFront();
    const Vec3 start = program_->touch().proxy;
    QPoint at = program_->centre();
    ratio = 0;
    while ((program_->touch().proxy - start).norm() < 2e-4) {
        QVERIFY2(at.x() < program_->window->view().width(), "the proxy never gives way");
        QVERIFY2(program_->touch().contacts == 1, "the finger has left the cube without breaking away");
        ratio = std::max(ratio, tangentialRatio(program_->touch()));
        program_->moveTo(at += QPoint(1, 0));
        program_->frames(4);
    }
    program_->release(at);
    // Back to where nothing is touched, so that the next press starts anew.
    program_->window->view().showStandardView(StandardView::Front);
    program_->frames(20);
}

void TestFirstTouch::theFingerStartsWhereItIsSeen_data() {
    QTest::addColumn<double>("yaw");
    QTest::addColumn<double>("pitch");
    QTest::addColumn<double>("scale");
    for (const double degrees : {0.0, 90.0, 180.0, 270.0, 45.0})
        QTest::addRow("from %g degrees", degrees) << degrees << 0.0 << 1.0;
    QTest::newRow("from above") << 0.0 << 90.0 << 1.0;
    QTest::newRow("as large as the workspace") << 0.0 << 0.0 << 2.4;
}

/// Wherever the camera stands: not behind the model, not out of the view, not beyond what the hand reaches.
void TestFirstTouch::theFingerStartsWhereItIsSeen() {
    QFETCH(const double, yaw);
    QFETCH(const double, pitch);
    QFETCH(const double, scale);
    constexpr double kDegree = std::numbers::pi / 180,
                     kReach = 0.95 * 0.15; // m, as HandLink has it for the simulated hand
    SceneView& view = program_->window->view();
    QVERIFY(program_->open(writeCube(folder_, scale)));
    QVERIFY(program_->atRest());
    const ViewCamera& camera = view.camera();
    const auto isSeen = [&](const Vec3& finger) {
        const auto at = camera.project(finger);
        if (!at || !QRectF(view.rect()).adjusted(20, 40, -20, -40).contains(*at)) return false;
        // The way of the eye to it meets no side of the cube.
        const double half = kHalf * scale;
        for (double part = 0; part < 1; part += 1e-3)
            if ((camera.eye() + part * (finger - camera.eye())).cwiseAbs().maxCoeff() <= half) return false;
        return true;
    };
    QVERIFY(isSeen(program_->finger()));
    COMPARE_NEAR(program_->finger(), view.handGoal(), 1e-3, "m"); // the wall of the workspace did not stop it
    QVERIFY(!program_->touch().contacts);
    // Another scene begins at the first view; what is added alone, or comes back after a study, at this one.
    view.moveCamera(yaw * kDegree, pitch * kDegree);
    view.fitAll();
    const auto place = view.placeBeside(kReach);
    QVERIFY(place && isSeen(*place));
    QCOMPARE_LT(place->norm(), kReach);
}

void TestFirstTouch::whatIsTouchedIsNamed() {
    const SceneView& view = program_->window->view();
    const auto textOf = [&](const char* name) {
        return program_->window->findChild<QLabel*>(QLatin1String(name))->text();
    };
    const ObjectId cube = program_->document.scene().objects.front().id;
    QTest::keyClick(program_->window.get(), Qt::Key_T);
    COMPARE_BEGINS(textOf("notice-text"), QStringLiteral("Nothing has been touched yet"));
    QCOMPARE(textOf("status-contacts"), QStringLiteral("free"));
    pressIntoTheFront();
    QTRY_COMPARE_WITH_TIMEOUT(textOf("status-contacts"), QStringLiteral("front"), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(textOf("plot-caption").startsWith(QStringLiteral("front  ")), kPatience);
    QCOMPARE(view.accessibleDescription(), QStringLiteral("front"));
    // A name of now, whatever it was when the surfaces were prepared; selected while the mouse holds on.
    program_->document.renameSurface({cube, 4}, QStringLiteral("face"));
    QTRY_COMPARE_WITH_TIMEOUT(view.accessibleDescription(), QStringLiteral("face"), kPatience);
    program_->document.select(SurfaceRef{cube, 1});
    QTest::keyClick(program_->window.get(), Qt::Key_T);
    QCOMPARE(program_->document.selection()->surface, Index(4));
    // And afterwards the one that was touched last.
    program_->release(program_->centre());
    QTRY_COMPARE_WITH_TIMEOUT(textOf("status-contacts"), QStringLiteral("free"), kPatience);
    QCOMPARE(view.accessibleDescription(), QString());
    program_->document.select(SurfaceRef{cube, 1});
    QTest::keyClick(program_->window.get(), Qt::Key_T);
    QCOMPARE(program_->document.selection()->surface, Index(4));
}

void TestFirstTouch::proxyStaysOutsideWhileFingerIsInside() {
    pressIntoTheFront();
    const double radius = program_->document.scene().proxyRadius;
    QCOMPARE_LT(program_->finger().z(), kHalf - radius);
    QCOMPARE_LT(std::abs(program_->finger().x()), kHalf);
    QCOMPARE_LT(std::abs(program_->finger().y()), kHalf);
    QVERIFY2(program_->touch().proxy.z() >= kHalf + radius * (1 - 2e-6), "the proxy is outside");
    // The spring between them is the force: K times their distance, outward.
    const double distance = program_->touch().proxy.z() - program_->engine.proxy().finger.z();
    COMPARE_NEAR(program_->touch().force.z(), kStiffness.initial * distance, 0.05, "N");
    // Without friction it neither sticks nor slips.
    const auto* status = program_->window->findChild<QLabel*>(QStringLiteral("status-contacts"));
    QTRY_COMPARE_WITH_TIMEOUT(status->text(), QStringLiteral("front"), kPatience);
    const auto picked = program_->document.selection();
    QVERIFY(picked.has_value());
}

void TestFirstTouch::frictionTypedIntoTheInspectorIsFeltAndUndone() {
    const ObjectId cube = program_->document.scene().objects.front().id;
    program_->document.select(SurfaceRef{cube, 4}); // front
    program_->type(QStringLiteral("static-friction"), QStringLiteral("0.3"));
    QCOMPARE(program_->document.scene().objects[0].surfaces[4].material.staticFriction, 0.3);
    QTRY_VERIFY_WITH_TIMEOUT(program_->caughtUp(), kPatience);
    double ratio = 0;
    breakAway(ratio);
    QVERIFY2(ratio > 0.2 && ratio < 0.31, qPrintable(QString::number(ratio)));

    program_->type(QStringLiteral("static-friction"), QStringLiteral("0.9"));
    QTRY_VERIFY_WITH_TIMEOUT(program_->caughtUp(), kPatience);
    breakAway(ratio);
    QVERIFY2(ratio > 0.75 && ratio < 0.91, qPrintable(QString::number(ratio)));

    QTest::keyClick(program_->window.get(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(program_->caughtUp(), kPatience);
    QCOMPARE(program_->box(QStringLiteral("static-friction")).text(), QStringLiteral("0.300"));
    breakAway(ratio);
    QVERIFY2(ratio > 0.2 && ratio < 0.31, qPrintable(QString::number(ratio)));
}

void TestFirstTouch::stopEndsTheForce() {
    pressIntoTheFront();
    // On a machine that stalls the force is on its way back.
    QTRY_VERIFY_WITH_TIMEOUT(program_->engine.servo().force.norm() > 0.1, kPatience);
    QTest::mouseClick(program_->window->findChild<QWidget*>(QStringLiteral("stop")), Qt::LeftButton);
    QVERIFY(!program_->engine.armed());
    QTRY_COMPARE_WITH_TIMEOUT(program_->engine.servo().force.norm(), 0.0, kPatience);
    QTest::keyClick(program_->window.get(), Qt::Key_Return, Qt::ControlModifier);
    QVERIFY(program_->engine.armed());
    // Esc, held: nothing at once, everything off after half a second.
    QTest::keyPress(program_->window.get(), Qt::Key_Escape);
    QVERIFY(program_->engine.armed());
    QTRY_VERIFY_WITH_TIMEOUT(!program_->engine.armed(), kPatience);
    QTest::keyRelease(program_->window.get(), Qt::Key_Escape);
}

/// "Drag on the model to touch it": with a model, and with the tool that touches.
void TestFirstTouch::whereNothingCanBeTouchedNobodyIsToldTo() {
    QSettings().clear(); // as before the first touch
    Document& document = program_->document;
    const auto* hint = program_->window->view().findChild<QLabel*>(QStringLiteral("hint"));
    QVERIFY(hint);
    const auto added = [&](std::size_t count) {
        return test::waitFor([&] { return document.scene().objects.size() == count && !document.opening(); });
    };
    document.begin({});
    QVERIFY(hint->isHidden());
    program_->command("add-box").trigger();
    QVERIFY(added(1));
    QVERIFY(!hint->isHidden());
    program_->command("arrange").trigger();
    QVERIFY(hint->isHidden());
    program_->command("add-sphere").trigger();
    QVERIFY(added(2));
    QVERIFY(hint->isHidden());
    QVERIFY(program_->open(writeCube(folder_)));
    QVERIFY(hint->isHidden());
    program_->command("touch").trigger();
    QVERIFY(!hint->isHidden());
}

TACTUM_GUI_TEST(TestFirstTouch)

} // namespace test_first_touch

#include "test_first_touch.moc"
