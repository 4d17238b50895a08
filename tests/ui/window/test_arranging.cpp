// Objects moved, turned and scaled in the window: by handles, by keys, by numbers; and felt meanwhile.
#include <algorithm>
#include <cmath>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "core/files/gltf/write_gltf.h"
#include "core/scene/bodies.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/obj_box.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/panels/place_panel.h"
#include "ui/tools/arrange_tool.h"
#include "ui/view/scene_view.h"

namespace test_arranging {

using namespace tactum;

namespace {

/// Two cubes of 40 mm, 100 mm apart.
QString writeTwo(const QTemporaryDir& folder) {
    int next = 1;
    // One by one: each counts the corners on.
    QByteArray text = objBox("left", {-0.07, -0.02, -0.02}, {-0.03, 0.02, 0.02}, next);
    text += objBox("right", {0.03, -0.02, -0.02}, {0.07, 0.02, 0.02}, next);
    return writeFile(folder, QStringLiteral("two.obj"), text);
}

/// The window with two cubes and the tool that arranges.
struct Desk {
    TouchedWindow program{{1400, 1000}};
    SceneView& view = program.window->view();
    ArrangeTool& tool = *program.window->findChild<ArrangeTool*>();
    bool opened;

    explicit Desk(const QTemporaryDir& folder) : opened(program.open(writeTwo(folder))) {
        program.command("select-none").trigger();
        program.command("view-front").trigger();
        program.command("arrange").trigger();
        program.frames(2);
    }
    const Scene& scene() const { return program.document.scene(); }
    /// 0: the left one, 1: the right one.
    const SceneObject& object(std::size_t i) const {
        return *std::ranges::find(scene().objects, i == 0 ? "left" : "right", &SceneObject::name);
    }
    Vec3 middle(std::size_t i) const { return tool.middleOf(object(i)); }
    double side(std::size_t i) const {
        const Bounds& box = tool.boxOf(object(i));
        return (box.high - box.low).x();
    }
    void mouse(QEvent::Type type, QPoint at, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton) {
        QWindow* window = program.window->windowHandle();
        const QPoint inWindow = view.mapTo(program.window.get(), at);
        if (type == QEvent::MouseButtonPress) QTest::mousePress(window, button, modifiers, inWindow);
        if (type == QEvent::MouseButtonRelease) QTest::mouseRelease(window, button, modifiers, inWindow);
        if (type != QEvent::MouseMove) return;
        const Qt::MouseButtons held = button == Qt::NoButton ? Qt::NoButton : Qt::MouseButtons(button);
        QMouseEvent move(type, at, view.mapToGlobal(QPointF(at)), Qt::NoButton, held, modifiers);
        QCoreApplication::sendEvent(&view, &move);
    }
    QPoint seen(const Vec3& p_W) const { return view.camera().project(p_W).value().toPoint(); }
    QPoint handle(ArrangeHandle which) const {
        return view.arranging().placeOf(which, view.camera()).value().toPoint();
    }
    void click(const Vec3& p_W, Qt::KeyboardModifiers modifiers = {}) {
        program.moveTo(seen(p_W));
        mouse(QEvent::MouseButtonPress, seen(p_W), modifiers);
        mouse(QEvent::MouseButtonRelease, seen(p_W), modifiers);
    }
    /// Takes a handle and leads it; the button stays down.
    void lead(ArrangeHandle which, QPoint by, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint from = handle(which);
        program.moveTo(from);
        mouse(QEvent::MouseButtonPress, from);
        for (int i = 1; i <= 5; ++i)
            mouse(QEvent::MouseMove, from + by * i / 5, modifiers);
        led = from + by;
    }
    void drag(ArrangeHandle which, QPoint by, Qt::KeyboardModifiers modifiers = {}) {
        lead(which, by, modifiers);
        mouse(QEvent::MouseButtonRelease, led, modifiers);
    }
    /// The dock of numbers to the front.
    void numbers() {
        program.window->findChild<QDockWidget*>(QStringLiteral("dock-place"))->raise();
        program.frames(2);
    }
    void key(int code) { QTest::keyClick(&view, Qt::Key(code)); }
    void type(const QString& number, Qt::KeyboardModifiers modifiers = {}) {
        for (const QChar each : number)
            QTest::keyClick(&view, each.toLatin1(), modifiers);
    }
    double pixel() const { return view.camera().pixelSize(view.arranging().shown()->translation); }
    void keep(const char* name) {
        if (const QString folder = qEnvironmentVariable("TACTUM_KEEP_PICTURES"); !folder.isEmpty())
            program.window->grab().save(folder + u'/' + QLatin1String(name) + QStringLiteral(".png"));
    }
    QPoint led; ///< where the pointer is
};

} // namespace

class TestArranging : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

public:
    static void initMain() { prepareProcess(); }

private slots:
    void init() { useSettingsIn(folder_.path()); }

    /// The panel of numbers shows those of one: the last.
    void theNumbersOfSeveralSayWhoseTheyAre() {
        Desk desk(folder_);
        QVERIFY(desk.opened);
        const auto texts = [&] {
            QStringList all;
            for (const QLabel* label : desk.program.window->findChild<PlacePanel*>()->findChildren<QLabel*>())
                if (label->property("heading").toBool()) all << label->text();
            return all;
        };
        desk.program.document.selectObjects({desk.object(0).id});
        QCOMPARE(texts(), QStringList{QStringLiteral("left")});
        desk.program.document.selectObjects({desk.object(0).id, desk.object(1).id});
        QCOMPARE(texts(), QStringList{QStringLiteral("2 objects, the figures of right")});
    }

    // Along x by the arrow: as far as the pointer went, in one step, and back to the byte.
    void anArrowMovesTheObject() {
        Desk desk(folder_);
        QVERIFY(desk.opened);
        QVERIFY(!desk.view.arranging().shown());
        const std::string before = glbOf(desk.scene()).value();
        desk.click({0.05, 0, 0.02});
        QVERIFY(desk.view.arranging().shown());
        COMPARE_NEAR(desk.view.arranging().shown()->translation, Vec3(0.05, 0, 0), 1e-9, "m");
        const int steps = desk.program.document.history().count();
        const double pixel = desk.pixel();
        desk.drag(ArrangeHandle::MoveX, {60, 25});
        desk.keep("arranged");
        COMPARE_NEAR(desk.middle(1).x(), 0.05 + 60 * pixel, 2 * pixel, "m");
        COMPARE_NEAR(desk.middle(1).tail<2>().norm(), 0, 1e-12, "m");
        COMPARE_NEAR(desk.middle(0), Vec3(-0.05, 0, 0), 1e-12, "m");
        COMPARE_NEAR(desk.view.arranging().shown()->translation, desk.middle(1), 1e-9, "m");
        QCOMPARE(desk.program.document.history().count(), steps + 1);
        QVERIFY(glbOf(desk.scene()).value() != before);
        desk.program.command("undo").trigger();
        QVERIFY(glbOf(desk.scene()).value() == before);
        desk.program.command("redo").trigger();
        QCOMPARE_GT(desk.middle(1).x(), 0.06);
    }

    // A turn and a growth of both about the middle of them all, in even steps.
    void severalTurnAndGrowTogether() {
        Desk desk(folder_);
        desk.click({-0.05, 0, 0.02});
        desk.click({0.05, 0, 0.02}, Qt::ShiftModifier);
        QCOMPARE(desk.tool.objects().size(), std::size_t(2));
        COMPARE_NEAR(desk.view.arranging().shown()->translation, Vec3(0, 0, 0), 1e-9, "m");
        const std::string before = glbOf(desk.scene()).value();
        const QPoint out = desk.handle(ArrangeHandle::Turn) - desk.seen({0, 0, 0});
        desk.drag(ArrangeHandle::Turn, QPoint(out.y(), -out.x()) - out, Qt::ControlModifier);
        desk.keep("turned");
        COMPARE_NEAR(desk.middle(1), Vec3(0, 0.05, 0), 1e-9, "m");
        COMPARE_NEAR(desk.middle(0), Vec3(0, -0.05, 0), 1e-9, "m");
        const QPoint wide = desk.handle(ArrangeHandle::Scale) - desk.seen({0, 0, 0});
        desk.drag(ArrangeHandle::Scale, wide / 2, Qt::ControlModifier);
        COMPARE_NEAR(desk.middle(1), Vec3(0, 0.075, 0), 1e-9, "m");
        COMPARE_NEAR(desk.side(1), 0.06, 1e-9, "m");
        // Each about its own middle: they stay where they are.
        desk.program.command("pivot-each").trigger();
        desk.drag(ArrangeHandle::Scale, -wide / 2, Qt::ControlModifier);
        COMPARE_NEAR(desk.middle(1), Vec3(0, 0.075, 0), 1e-9, "m");
        COMPARE_NEAR(desk.side(1), 0.03, 1e-9, "m");
        desk.program.command("pivot-last").trigger();
        COMPARE_NEAR(desk.view.arranging().shown()->translation, Vec3(0, 0.075, 0), 1e-9, "m");
        desk.program.command("pivot-world").trigger();
        desk.program.document.select(SurfaceRef{desk.object(1).id, 0}); // whose middle is elsewhere
        COMPARE_NEAR(desk.view.arranging().shown()->translation, Vec3(0, 0, 0), 1e-9, "m");
        desk.program.command("axes-own").trigger();
        COMPARE_NEAR(desk.view.arranging().shown()->rotate(Vec3::UnitX()), Vec3(0, 1, 0), 1e-9, "");
        for (int i = 0; i < 3; ++i)
            desk.program.command("undo").trigger();
        QVERIFY(glbOf(desk.scene()).value() == before);
    }

    // Esc, or the right button, in the middle of a drag: nothing of it is left, not even a step to undo, and
    // what was undone before can be redone.
    void aDragIsGivenUpWithoutATrace() {
        Desk desk(folder_);
        desk.click({0.05, 0, 0.02});
        const std::string before = glbOf(desk.scene()).value();
        desk.drag(ArrangeHandle::MoveX, {60, 0});
        const std::string undone = glbOf(desk.scene()).value();
        QVERIFY(undone != before);
        const int steps = desk.program.document.history().count();
        desk.program.command("undo").trigger();
        for (const bool byKey : {true, false}) {
            desk.lead(ArrangeHandle::MoveXY, {40, -30});
            QCOMPARE_GT(desk.middle(1).y(), 1e-3);
            if (byKey)
                desk.key(Qt::Key_Escape);
            else
                desk.mouse(QEvent::MouseButtonPress, desk.led, {}, Qt::RightButton);
            QVERIFY(glbOf(desk.scene()).value() == before);
            desk.mouse(QEvent::MouseMove, desk.led + QPoint(50, 50));
            desk.mouse(QEvent::MouseButtonRelease, desk.led);
            QVERIFY(glbOf(desk.scene()).value() == before);
            QCOMPARE(desk.program.document.history().count(), steps);
            QVERIFY(!desk.program.document.modified());
            COMPARE_NEAR(desk.view.arranging().shown()->translation, Vec3(0.05, 0, 0), 1e-9, "m");
        }
        desk.program.command("redo").trigger();
        QVERIFY(glbOf(desk.scene()).value() == undone);
    }

    // In the middle of a drag: undo gives it up and takes back what was done before; another edit keeps it.
    void aDragAndTheHistoryDoNotMixUp() {
        Desk desk(folder_);
        QUndoStack& history = desk.program.document.history();
        desk.click({0.05, 0, 0.02});
        const std::string before = glbOf(desk.scene()).value();
        desk.drag(ArrangeHandle::MoveX, {60, 0});
        const std::string moved = glbOf(desk.scene()).value();
        desk.lead(ArrangeHandle::MoveXY, {40, -30});
        history.undo();
        QVERIFY(glbOf(desk.scene()).value() == before);
        desk.mouse(QEvent::MouseButtonRelease, desk.led);
        history.redo();
        QVERIFY(glbOf(desk.scene()).value() == moved);
        QVERIFY(!history.canRedo());
        const int steps = history.count();
        desk.lead(ArrangeHandle::MoveXY, {40, -30});
        QCOMPARE(history.count(), steps); // no step yet, but unsaved
        QVERIFY(desk.program.document.modified());
        const std::string led = glbOf(desk.scene()).value();
        desk.program.document.setProxyRadius(0.0071);
        desk.mouse(QEvent::MouseButtonRelease, desk.led);
        QCOMPARE(history.count(), steps + 2);
        history.undo();
        QVERIFY(glbOf(desk.scene()).value() == led);
        history.undo();
        QVERIFY(glbOf(desk.scene()).value() == moved);
        // There and back again is no step.
        const int all = history.count();
        desk.lead(ArrangeHandle::MoveXY, {40, -30});
        desk.mouse(QEvent::MouseMove, desk.led - QPoint(40, -30));
        desk.mouse(QEvent::MouseButtonRelease, desk.led - QPoint(40, -30));
        QVERIFY(glbOf(desk.scene()).value() == moved);
        QCOMPARE(history.count(), all);
    }

    // As in Blender: G X and the mouse, Enter; R and a click; S and Esc. Y is no command meanwhile.
    void keysTakeHoldOfTheObject() {
        Desk desk(folder_);
        desk.view.setFocus();
        desk.click({0.05, 0, 0.02});
        const QPoint from = desk.seen({0.05, 0, 0.02}) + QPoint(70, 0);
        desk.mouse(QEvent::MouseMove, from, {}, Qt::NoButton);
        const int steps = desk.program.document.history().count();
        const double pixel = desk.pixel();
        desk.key(Qt::Key_G);
        desk.key(Qt::Key_Y);
        desk.mouse(QEvent::MouseMove, from + QPoint(25, -50), {}, Qt::NoButton);
        COMPARE_NEAR(desk.middle(1).x(), 0.05, 1e-9, "m");
        COMPARE_NEAR(desk.middle(1).y(), 50 * pixel, 2 * pixel, "m");
        desk.key(Qt::Key_Return);
        desk.mouse(QEvent::MouseMove, from, {}, Qt::NoButton);
        COMPARE_NEAR(desk.middle(1).y(), 50 * pixel, 2 * pixel, "m");
        QCOMPARE(desk.program.document.history().count(), steps + 1);
        const QPoint centre = desk.seen(desk.middle(1));
        desk.mouse(QEvent::MouseMove, centre + QPoint(80, 0), {}, Qt::NoButton);
        desk.key(Qt::Key_R);
        desk.mouse(QEvent::MouseMove, centre + QPoint(0, -80), {}, Qt::NoButton);
        desk.mouse(QEvent::MouseButtonPress, centre + QPoint(0, -80));
        desk.mouse(QEvent::MouseButtonRelease, centre + QPoint(0, -80));
        COMPARE_NEAR(Vec3(desk.object(1).pose.rotate(Vec3::UnitX())), Vec3(0, 1, 0), 0.05, "");
        QCOMPARE(desk.program.document.history().count(), steps + 2);
        desk.key(Qt::Key_S);
        desk.mouse(QEvent::MouseMove, centre + QPoint(0, -160), {}, Qt::NoButton);
        QCOMPARE_GT(desk.side(1), 0.07);
        desk.key(Qt::Key_Escape);
        COMPARE_NEAR(desk.side(1), 0.04, 1e-12, "m");
        QCOMPARE(desk.program.document.history().count(), steps + 2);
    }

    // As in Blender: what is typed counts, to the digit, and not the mouse; each of it is one step.
    void aNumberIsTypedWhileItIsHeld() {
        Desk desk(folder_);
        desk.view.setFocus();
        desk.click({0.05, 0, 0.02});
        const int steps = desk.program.document.history().count();
        desk.key(Qt::Key_G);
        desk.type(QStringLiteral("12.5"));
        COMPARE_NEAR(desk.middle(1), Vec3(0.0625, 0, 0), 1e-12, "m");
        desk.key(Qt::Key_Y);
        COMPARE_NEAR(desk.middle(1), Vec3(0.05, 0.0125, 0), 1e-12, "m");
        desk.mouse(QEvent::MouseMove, desk.seen({0.05, 0, 0.02}) + QPoint(90, 30), {}, Qt::NoButton);
        COMPARE_NEAR(desk.middle(1), Vec3(0.05, 0.0125, 0), 1e-12, "m");
        desk.key(Qt::Key_Minus);
        desk.key(Qt::Key_Backspace);
        COMPARE_NEAR(desk.middle(1), Vec3(0.05, -0.012, 0), 1e-12, "m");
        desk.keep("typed");
        desk.key(Qt::Key_Return);
        COMPARE_NEAR(desk.middle(1), Vec3(0.05, -0.012, 0), 1e-12, "m");
        QCOMPARE(desk.program.document.history().count(), steps + 1);

        desk.key(Qt::Key_R);
        desk.key(Qt::Key_Z);
        desk.type(QStringLiteral("-90"));
        desk.key(Qt::Key_Return);
        COMPARE_NEAR(Vec3(desk.object(1).pose.rotate(Vec3::UnitX())), Vec3(0, -1, 0), 1e-12, "");
        desk.key(Qt::Key_S);
        desk.type(QStringLiteral("0,5")); // nought and its point scale nothing yet
        COMPARE_NEAR(desk.side(1), 0.02, 1e-12, "m");
        desk.key(Qt::Key_Escape);
        COMPARE_NEAR(desk.side(1), 0.04, 1e-12, "m");
        QCOMPARE(desk.program.document.history().count(), steps + 2);

        // With a handle as well, along what it moves along. The next drag begins without the number.
        desk.lead(ArrangeHandle::MoveY, {0, -20});
        desk.type(QStringLiteral("3"));
        desk.mouse(QEvent::MouseButtonRelease, desk.led);
        COMPARE_NEAR(desk.middle(1), Vec3(0.05, -0.009, 0), 1e-12, "m");
        desk.drag(ArrangeHandle::MoveX, {50, 0});
        QCOMPARE_GT(desk.middle(1).x(), 0.055);
    }

    // The numeric pad, whose digits turn the camera at other times.
    void theNumericPadTypesToo() {
        Desk desk(folder_);
        desk.view.setFocus();
        desk.click({0.05, 0, 0.02});
        const double yaw = desk.view.camera().yaw;
        desk.key(Qt::Key_G);
        desk.type(QStringLiteral("3"), Qt::KeypadModifier);
        COMPARE_NEAR(desk.middle(1).x(), 0.053, 1e-12, "m");
        COMPARE_NEAR(desk.view.camera().yaw, yaw, 1e-12, "rad");
    }

    // Shift in the middle of a drag: a tenth of the way.
    void shiftIsPrecise() {
        Desk desk(folder_);
        desk.click({0.05, 0, 0.02});
        const double pixel = desk.pixel();
        desk.drag(ArrangeHandle::MoveX, {100, 0}, Qt::ShiftModifier);
        COMPARE_NEAR(desk.middle(1).x(), 0.05 + 10 * pixel, pixel, "m");
    }

    void whatIsLockedStays() {
        Desk desk(folder_);
        desk.click({0.05, 0, 0.02});
        desk.program.command("lock").trigger();
        QVERIFY(!desk.view.arranging().shown());
        const std::string before = glbOf(desk.scene()).value();
        desk.view.setFocus();
        desk.key(Qt::Key_G);
        desk.mouse(QEvent::MouseMove, desk.seen({0, 0, 0}), {}, Qt::NoButton);
        desk.numbers();
        desk.program.type(QStringLiteral("place-x"), QStringLiteral("10"));
        QVERIFY(glbOf(desk.scene()).value() == before);
        QVERIFY(desk.tool.whyNot().contains(QStringLiteral("right")));
        desk.click({-0.05, 0, 0.02}, Qt::ShiftModifier); // with it one that is free: that one alone
        QCOMPARE(desk.tool.objects(), std::vector{desk.object(0).id});
    }

    // What no hand means is brought into bounds: ten metres of way, and of size.
    void whatNoHandMeansIsBounded() {
        Desk desk(folder_);
        desk.click({0.05, 0, 0.02});
        Arrangement by;
        by.move = {100, 0, 0};
        desk.tool.place(by, 0);
        COMPARE_NEAR(desk.middle(1).x(), 10.05, 1e-9, "m");
        by = {};
        by.scale = 1e9;
        desk.tool.place(by, 0);
        COMPARE_NEAR(desk.side(1), 10 / std::sqrt(3.0), 1e-9, "m");
    }

    // In mm and degrees, to the digit.
    void numbersAreTyped() {
        Desk desk(folder_);
        desk.click({0.05, 0, 0.02});
        desk.numbers();
        const std::string before = glbOf(desk.scene()).value();
        desk.program.type(QStringLiteral("place-x"), QStringLiteral("12.345"));
        desk.program.type(QStringLiteral("place-z"), QStringLiteral("-1 in"));
        COMPARE_NEAR(desk.middle(1), Vec3(0.012345, 0, -0.0254), 1e-12, "m");
        desk.program.type(QStringLiteral("turn-y"), QStringLiteral("90"));
        COMPARE_NEAR(Vec3(desk.object(1).pose.rotate(Vec3::UnitX())), Vec3(0, 0, -1), 1e-12, "");
        COMPARE_NEAR(desk.middle(1), Vec3(0.012345, 0, -0.0254), 1e-12, "m");
        desk.program.type(QStringLiteral("turn-x"), QStringLiteral("30"));
        COMPARE_NEAR(desk.program.box(QStringLiteral("turn-x")).value(), 30, 1e-9, "degrees");
        COMPARE_NEAR(desk.program.box(QStringLiteral("turn-y")).value(), 90, 1e-9, "degrees");
        desk.program.type(QStringLiteral("longest-side"), QStringLiteral("55.5"));
        COMPARE_NEAR(desk.side(1), 0.0555, 1e-12, "m");
        desk.program.type(QStringLiteral("scale"), QStringLiteral("1.5"));
        COMPARE_NEAR(desk.side(1), 0.06, 1e-12, "m");
        COMPARE_NEAR(desk.program.box(QStringLiteral("longest-side")).value(), 60, 1e-9, "mm");
        desk.keep("place");
        while (desk.program.document.history().canUndo() && glbOf(desk.scene()).value() != before)
            desk.program.command("undo").trigger();
        QVERIFY(glbOf(desk.scene()).value() == before);
        COMPARE_NEAR(desk.program.box(QStringLiteral("place-x")).value(), 50, 1e-9, "mm");
    }

    // A finger that presses on a cube while it is moved away feels less, and more when it comes: no jump
    // above the limit, no fault, no second press.
    void itIsFeltWhileItMoves() {
        Desk desk(folder_);
        desk.program.command("touch").trigger();
        QVERIFY(desk.program.fullForce());
        const QPoint top = desk.seen({0.05, 0, 0.02});
        desk.program.press(top);
        desk.program.frames(60);
        QVERIFY(test::waitFor([&] { return desk.program.touch().force.norm() > 0.2; }));
        desk.program.release(top);
        QVERIFY(desk.program.atRest());
        for (int i = 0; i < 20 && desk.program.touch().force.norm() < 0.3;
             ++i) { // what keys press in stays in
            QTest::keyClick(&desk.program.window->view(), Qt::Key_PageUp);
            QVERIFY(desk.program.atRest());
        }
        desk.program.command("arrange").trigger();
        desk.program.document.select(SurfaceRef{desk.object(1).id, 0});
        const double pressed = desk.program.touch().force.norm();
        QCOMPARE_GT(pressed, 0.2);
        desk.numbers();
        desk.program.type(QStringLiteral("place-z"), QStringLiteral("1")); // a millimetre toward the finger
        QVERIFY(test::waitFor([&] { return desk.program.touch().force.norm() > pressed + 0.2; }));
        QCOMPARE_LT(desk.program.engine.servo().force.norm(), desk.program.engine.device().maxForce + 1e-9);
        desk.program.type(QStringLiteral("place-z"), QStringLiteral("-30"));
        QVERIFY(test::waitFor([&] { return desk.program.touch().force.norm() == 0; }));
        QVERIFY(desk.program.engine.armed());
    }

    // What moves by forces is taken with what hangs on it; the world stands still at its beginning meanwhile.
    void aBodyIsArrangedWhereItBegins() {
        Desk desk(folder_);
        desk.click({0.05, 0, 0.02});
        desk.program.command("body-loose").trigger();
        QVERIFY(test::waitFor([&] { return desk.program.caughtUp(); }));
        desk.program.frames(20); // it falls
        QVERIFY(desk.program.command("motion-run").isChecked());
        desk.drag(ArrangeHandle::MoveX, {40, 0});
        QVERIFY(!desk.program.command("motion-run").isChecked());
        const RigidBody& body = desk.scene().mechanics.bodies[0];
        COMPARE_NEAR(body.pose.translation, desk.object(1).pose.translation, 1e-12, "m");
        QCOMPARE_GT(desk.middle(1).x(), 0.055);
        COMPARE_NEAR(desk.middle(1).y(), 0, 1e-12, "m");
    }
};

TACTUM_GUI_TEST(TestArranging)

} // namespace test_arranging

#include "test_arranging.moc"
