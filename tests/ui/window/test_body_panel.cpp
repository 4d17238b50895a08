// Bodies and joints made in the window with real events: a crank with its rod and piston out of bare meshes.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

#include "core/files/gltf/write_gltf.h"
#include "core/haptics/body_places.h"
#include "core/haptics/compile.h"
#include "core/scene/bodies.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/obj_box.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/panels/body_panel.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace test_body_panel {

using namespace tactum;

namespace {

/// A wheel of 30 mm with a peg at 20 mm, a rod of 70 mm and a piston, in line; a base far below.
QString writeCrank(const QTemporaryDir& folder) {
    int next = 1;
    QByteArray text = objBox("base", {-0.09, -0.06, -0.03}, {0.09, -0.05, 0.03}, next);
    text += objBox("wheel", {-0.08, -0.03, -0.004}, {-0.02, 0.03, 0.004}, next);
    text += objBox(nullptr, {-0.034, -0.004, 0.02}, {-0.026, 0.004, 0.04}, next);
    text += objBox("rod", {-0.034, -0.003, 0.006}, {0.044, 0.003, 0.012}, next);
    text += objBox("piston", {0.03, -0.01, 0.013}, {0.06, 0.01, 0.019}, next);
    return writeFile(folder, QStringLiteral("crank.obj"), text);
}

/// Leads a handle away from `from` and gives it up by Esc, between an undo and its redo: both are as they
/// were.
void giveUpADrag(TouchedWindow& program, QPoint from) {
    const Scene& scene = program.document.scene();
    const std::string last = glbOf(scene).value();
    program.command("undo").trigger();
    const std::string before = glbOf(scene).value();
    program.press(from);
    program.moveTo(from + QPoint(20, -35));
    program.moveTo(from + QPoint(40, -70));
    QVERIFY(glbOf(scene).value() != before); // else no handle was there
    QTest::keyClick(&program.window->view(), Qt::Key_Escape);
    program.release(from + QPoint(40, -70));
    QVERIFY(glbOf(scene).value() == before);
    program.command("redo").trigger();
    QVERIFY(glbOf(scene).value() == last);
}

} // namespace

class TestBodyPanel : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static void choose(TouchedWindow& program, const QString& name) {
        auto* outliner = program.window->findChild<QTreeWidget*>(QStringLiteral("outliner"));
        for (int i = 0; i < outliner->topLevelItemCount(); ++i)
            if (outliner->topLevelItem(i)->text(0) == name) {
                QTest::mouseClick(outliner->viewport(), Qt::LeftButton, {},
                                  outliner->visualItemRect(outliner->topLevelItem(i)).center());
                return;
            }
        QFAIL(qPrintable(name));
    }
    static void push(TouchedWindow& program, const char* name) {
        auto* button = program.window->findChild<QToolButton*>(QLatin1String(name));
        QVERIFY2(button && button->isVisible(), name);
        // Rows that have just come have no height until they are laid out; nobody can hit that.
        QVERIFY2(test::waitFor([&] { return !button->size().isEmpty(); }), name);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    static void fixTo(TouchedWindow& program, const QString& name) {
        auto* to = program.window->findChild<QComboBox*>(QStringLiteral("joint-to"));
        const int row = to->findText(name);
        QVERIFY2(row >= 0, qPrintable(name));
        to->setFocus();
        while (to->currentIndex() != row)
            QTest::keyClick(to, to->currentIndex() < row ? Qt::Key_Down : Qt::Key_Up);
    }
    /// To be looked at.
    static void keep(TouchedWindow& program, const char* name) {
        if (const QString folder = qEnvironmentVariable("TACTUM_KEEP_PICTURES"); !folder.isEmpty())
            program.window->grab().save(folder + u'/' + QLatin1String(name) + QStringLiteral(".png"));
    }
    static void place(TouchedWindow& program, const Vec3& millimetres) {
        const char* keys[] = {"joint-x", "joint-y", "joint-z"};
        for (int i = 0; i < 3; ++i)
            program.type(QLatin1String(keys[i]), QString::number(millimetres[i]));
    }

public:
    static void initMain() { prepareProcess(); }

private slots:
    void init() {
        useSettingsIn(folder_.path());
        unfoldPlots();
    }

    void aCrankOutOfBareMeshes() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        const std::string before = glbOf(program.document.scene()).value();
        choose(program, QStringLiteral("wheel"));
        program.command("body-hinge").trigger(); // shows the dock, too
        push(program, "axis-z");
        place(program, {-50, 0, 0});
        choose(program, QStringLiteral("rod"));
        push(program, "hold-hinge");
        fixTo(program, QStringLiteral("wheel"));
        push(program, "axis-z");
        place(program, {-30, 0, 9});
        choose(program, QStringLiteral("piston"));
        push(program, "hold-slider");
        push(program, "axis-x");
        push(program, "joint-add");
        fixTo(program, QStringLiteral("rod"));
        push(program, "axis-z");
        place(program, {40, 0, 9});
        const Mechanics& mechanics = program.document.scene().mechanics;
        QCOMPARE(mechanics.bodies.size(), std::size_t(3));
        QCOMPARE(mechanics.joints.size(), std::size_t(4));
        COMPARE_NEAR(mechanics.bodies[1].mass, 1000 * 0.078 * 0.006 * 0.006, 1e-6, "kg");
        // Of a box the ellipsoid of the same moments has sqrt(5 / 12) of its sides.
        choose(program, QStringLiteral("rod"));
        const auto& mass = program.window->findChild<SceneView*>()->mass();
        QVERIFY(mass);
        COMPARE_NEAR(mass->half.maxCoeff(), std::sqrt(5.0 / 12) * 0.078, 1e-6, "m");
        COMPARE_NEAR(mass->half.minCoeff(), std::sqrt(5.0 / 12) * 0.006, 1e-6, "m");
        COMPARE_NEAR((mass->pose.translation - Vec3(0.005, 0, 0.009)).norm(), 0, 1e-6, "m");
        keep(program, "rod");
        choose(program, QStringLiteral("piston"));
        keep(program, "crank");

        // It closes, and the hand turns it: the piston goes where the triangle of wheel and rod puts it.
        QVERIFY(test::waitFor([&] { return program.caughtUp(); }));
        const auto world = compile(program.document.scene()).value();
        QVERIFY(world->moving);
        QCOMPARE(world->moving->mechanism()->loopJoints, std::size_t(1));
        program.frames(60);
        BodyPlaces places(world.get());
        const auto poseOf = [&](const char* name) {
            for (const PlacedObject& placed : places.at(program.engine.proxy().bodies))
                if (program.document.scene().find(placed.object)->name == name) return placed.pose;
            return Pose{};
        };
        const Vec3 peg = poseOf("wheel").apply({-0.03, 0, 0.009}),
                   pin = poseOf("piston").apply({0.04, 0, 0.009});
        QVERIFY(std::abs(peg.y()) > 1e-4); // it does not stand on its dead point: the peg weighs
        COMPARE_NEAR((peg - pin).norm(), 0.07, 1e-6, "m");
        COMPARE_NEAR(pin.y(), 0, 1e-6, "m");

        // Without weight it stands; the hand presses on the peg from above and turns the wheel, and the
        // piston is drawn along by its rod. Damped, or the first touch would send it down to its lowest
        // place.
        choose(program, QStringLiteral("wheel"));
        program.type(QStringLiteral("hinge-damping"), QStringLiteral("0.01"));
        program.command("select-none").trigger();
        program.type(QStringLiteral("gravity-y"), QStringLiteral("0"));
        QVERIFY(test::waitFor([&] { return program.caughtUp(); }));
        program.command("motion-reset").trigger();
        program.command("view-top").trigger();
        program.command("touch").trigger();
        QVERIFY(program.fullForce());
        const auto pegAt = [&] { return poseOf("wheel").apply({-0.03, 0, 0.009}); };
        program.frames(10);
        COMPARE_NEAR(pegAt().y(), 0, 1e-6, "m");
        const SceneView& view = program.window->view();
        const QPoint pegSeen = view.camera().project({-0.03, 0.004, 0.032}).value().toPoint();
        program.press(pegSeen);
        QVERIFY(test::waitFor([&] { return pegAt().y() < -1e-3; }));
        program.frames(10); // until the plot has them all
        // Every tick counts: a push may be shorter than a frame.
        double strongest = 0;
        for (const TouchSample& sample : program.window->findChild<ForcePlot*>()->history().samples())
            strongest = std::max(strongest, sample.magnitude);
        QCOMPARE_GT(strongest, 1e-3);
        QCOMPARE_LE(strongest, program.engine.device().maxForce * (1 + 1e-9));
        const double shallow = pegAt().y();
        program.wheel(pegSeen, 8); // deeper
        QVERIFY(test::waitFor([&] { return pegAt().y() < shallow - 2e-3; }));
        keep(program, "pushed");
        const Vec3 pushed = pegAt(), drawn = poseOf("piston").apply({0.04, 0, 0.009});
        COMPARE_NEAR((pushed - drawn).norm(), 0.07, 1e-6, "m");
        COMPARE_NEAR(drawn.y(), 0, 1e-6, "m");
        program.release(pegSeen);

        while (program.document.history().canUndo())
            program.command("undo").trigger();
        QVERIFY(glbOf(program.document.scene()).value() == before);
        while (program.document.history().canRedo())
            program.command("redo").trigger();
        QCOMPARE(program.document.scene().mechanics.joints.size(), std::size_t(4));
    }

    // The strips of a selected pendulum: its period is 2 pi sqrt(I / (m g d)), its energy stays.
    void theJointOfTheSelectedBodyIsPlotted() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        choose(program, QStringLiteral("piston"));
        program.command("body-hinge").trigger();
        push(program, "axis-z");
        place(program, {30, 0, 16});
        program.type(QStringLiteral("hinge-damping"), QStringLiteral("0"));
        QCOMPARE(
            axisJointOf(program.document.scene(), program.document.scene().mechanics.bodies[0].id)->damping,
            0.0);
        QVERIFY(test::waitFor([&] { return program.caughtUp(); }));
        program.frames(5); // until the menu knows that there is something to reset
        program.command("motion-reset").trigger();
        auto* plot = program.window->findChild<ForcePlot*>();
        auto* angle = plot->findChild<QToolButton*>(QStringLiteral("plot-joint-angle"));
        QVERIFY(angle);
        // A row of tools is laid out when there is time.
        QVERIFY(test::waitFor([&] { return angle->isVisibleTo(plot); }));
        QVERIFY(!plot->findChild<QToolButton*>(QStringLiteral("plot-joint-way"))->isVisibleTo(plot));
        QTest::mouseClick(angle, Qt::LeftButton);
        QTest::mouseClick(plot->findChild<QToolButton*>(QStringLiteral("plot-body-energy")), Qt::LeftButton);
        double low = 0, high = 0;
        QVERIFY(test::waitFor([&] {
            program.frames(10);
            for (const TouchSample& sample : plot->history().samples())
                low = std::min(low, sample.jointAngle), high = std::max(high, sample.jointAngle);
            return high - low > 3;
        }));
        keep(program, "plot");
        QCOMPARE_LT(high - low, std::numbers::pi + 0.01); // from the level down and up again
        const TouchSample& now = plot->history().samples().back();
        COMPARE_NEAR(now.kinetic + now.potential, 0, 1e-9, "J");
        choose(program, QStringLiteral("base"));
        program.frames(5);
        QVERIFY(test::waitFor([&] { return !angle->isVisibleTo(plot); }));
    }

    // What fell, and falls no more, is where it was; nor is a thing of the next scene where one of its number
    // fell.
    void whatNoForceMovesAnyMoreIsWhereItWas() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        const SceneView& view = program.window->view();
        choose(program, QStringLiteral("piston"));
        const SceneObject piston =
            *std::ranges::find(program.document.scene().objects, "piston", &SceneObject::name);
        program.command("body-loose").trigger();
        const auto away = [&] {
            return (view.placeOf(piston.id)->translation - piston.pose.translation).norm();
        };
        QVERIFY(test::waitFor([&] { return program.frames(2), away() > 1e-3; }));
        program.command("undo").trigger();
        QVERIFY(test::waitFor([&] { return program.caughtUp(); }));
        program.frames(5);
        COMPARE_NEAR(away(), 0, 1e-12, "m");
        const QString moving = QStringLiteral(TACTUM_RESOURCES "/scenes/moving/");
        QVERIFY(program.open(moving + QStringLiteral("dominoes.glb")));
        QVERIFY(program.open(moving + QStringLiteral("kettle.glb")));
        int still = 0;
        for (const SceneObject& object : program.document.scene().objects)
            if (object.body == kWorldBody) {
                COMPARE_NEAR(view.placeOf(object.id).value().translation, object.pose.translation, 1e-12,
                             "m");
                ++still;
            }
        QCOMPARE(still, 2); // table and kettle
    }

    // As long as a block stands still the plate is dark at its foot; a dark place would stay there for good
    // when it goes away.
    void whatMovesLeavesNoDarkPlace() {
        int corner = 1;
        const QByteArray text = objBox("plate", {-0.1, -0.01, -0.1}, {0.1, 0, 0.1}, corner) +
                                objBox("block", {-0.03, 0, -0.03}, {0.03, 0.06, 0.03}, corner);
        TouchedWindow program;
        QVERIFY(program.open(writeFile(folder_, QStringLiteral("block.obj"), text)));
        SceneView& view = program.window->view();
        const auto lightAtItsFoot = [&] {
            [&] { QTRY_VERIFY_WITH_TIMEOUT(!view.makesFelt() && !view.makesMeshes(), kPatience); }();
            program.frames(5);
            const QPointF at = *view.camera().project({0.033, 0, 0}) * view.devicePixelRatioF();
            return view.grabPicture().pixelColor(at.toPoint()).lightness();
        };
        if (program.command("motion-run").isChecked()) program.command("motion-run").trigger();
        program.command("select-none").trigger();
        const int before = lightAtItsFoot();
        choose(program, QStringLiteral("block"));
        program.command("body-loose").trigger();
        program.command("select-none").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(lightAtItsFoot() > before + 10, kPatience);
        program.command("undo").trigger();
        program.command("select-none").trigger();
        QTRY_COMPARE_WITH_TIMEOUT(lightAtItsFoot(), before, kPatience);
    }

    // What is of no single body is edited where nothing is selected.
    void theWorldIsScaled() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        choose(program, QStringLiteral("piston"));
        program.command("body-loose").trigger();
        program.command("select-none").trigger();
        program.type(QStringLiteral("force-scale"), QStringLiteral("0.5"));
        program.type(QStringLiteral("gravity-y"), QStringLiteral("-1.62"));
        keep(program, "world");
        QCOMPARE(program.document.scene().mechanics.forceScale, 0.5);
        QCOMPARE(program.document.scene().mechanics.gravity.y(), -1.62);
        program.command("undo").trigger();
        QCOMPARE(program.document.scene().mechanics.gravity.y(), -kEarthGravity);
    }

    // A path: its points are dragged, made by dragging between them, and picked on the model.
    void aPathIsDraggedAndPicked() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        program.command("view-front").trigger();
        const std::string before = glbOf(program.document.scene()).value();
        choose(program, QStringLiteral("piston"));
        program.command("body-path").trigger();
        const SceneView& view = program.window->view();
        QTRY_VERIFY_WITH_TIMEOUT(view.path().mark(), kPatience);
        const auto jointNow = [&] {
            const Scene& scene = program.document.scene();
            return axisJointOf(scene, scene.mechanics.bodies[0].id).value();
        };
        QCOMPARE(jointNow().path.points.size(), std::size_t(3));
        const auto drag = [&](int handle, QPoint by) {
            const QPoint from = view.path().placeOf(handle, view.camera()).value().toPoint();
            program.press(from);
            program.moveTo(from + by / 2);
            program.moveTo(from + by);
            program.release(from + by);
        };
        int steps = program.document.history().count();
        const Vec3 end = jointNow().path.points[2];
        const double pixel = view.camera().pixelSize(end);
        drag(2, {10, -60});
        QCOMPARE(program.document.history().count(), ++steps);
        COMPARE_NEAR(jointNow().path.points[2], Vec3(end + pixel * Vec3(10, 60, 0)), 2 * pixel, "m");
        drag(3, {0, 40}); // between the first two
        QCOMPARE(program.document.history().count(), ++steps);
        QCOMPARE(jointNow().path.points.size(), std::size_t(4));
        push(program, "path-fewer");
        QCOMPARE(jointNow().path.points.size(), std::size_t(3));
        giveUpADrag(program, view.path().placeOf(1, view.camera()).value().toPoint());
        // All in one line: no smooth curve closes through them.
        auto* closed = program.window->findChild<QCheckBox*>(QStringLiteral("path-closed"));
        closed->click();
        QVERIFY(!jointNow().path.closed && !closed->isChecked());
        drag(1, {-150, 0});
        closed->click();
        QVERIFY(jointNow().path.closed && closed->isChecked());
        keep(program, "path");
        program.command("touch").trigger();
        program.command("motion-run").setChecked(false);
        program.command("motion-reset").trigger();
        push(program, "path-pick");
        for (const Vec3& place : {Vec3(-0.08, -0.055, 0.03), {0.08, -0.055, 0.03}, {-0.07, 0.02, 0.004}}) {
            const QPoint at = view.camera().project(place).value().toPoint();
            program.press(at);
            program.release(at);
        }
        const JointPath picked = jointNow().path;
        QCOMPARE(picked.points.size(), std::size_t(3));
        COMPARE_NEAR(picked.points[1], Vec3(0.08, -0.055, 0.03), 1e-3, "m");
        push(program, "path-pick");
        while (program.document.history().canUndo())
            program.command("undo").trigger();
        QVERIFY(glbOf(program.document.scene()).value() == before);
    }

    // As what others meet it: drawn on request, changed by the list, undone, saved.
    void collidersAreSeenAndChanged() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        choose(program, QStringLiteral("piston"));
        program.command("body-loose").trigger();
        const SceneView& view = program.window->view();
        QVERIFY(view.colliders().empty());
        program.command("colliders").trigger();
        const Scene& scene = program.document.scene();
        QCOMPARE(view.colliders().size(), scene.mechanics.colliders.size());
        auto* form = program.window->findChild<QComboBox*>(QStringLiteral("collider-form"));
        QVERIFY(form && form->isVisible());
        QCOMPARE(form->currentText(), QStringLiteral("One hull"));
        const std::string before = glbOf(scene).value();
        form->setFocus();
        for (int i = 0; i < form->count() && form->currentText() != QStringLiteral("Cylinder"); ++i)
            QTest::keyClick(form, Qt::Key_Down);
        QCOMPARE(form->currentText(), QStringLiteral("Cylinder"));
        const BodyId body = scene.mechanics.bodies[0].id;
        const auto shape = std::ranges::find(scene.mechanics.colliders, body, &Collider::body)->shape;
        QVERIFY(shape.kind == ShapeKind::Cylinder);
        keep(program, "colliders");
        const std::string changed = glbOf(scene).value();
        QVERIFY(changed != before);
        // Each of the keys was a step; every form has been the body's.
        while (glbOf(scene).value() != before)
            program.command("undo").trigger();
        QCOMPARE(form->currentText(), QStringLiteral("One hull"));
        program.command("colliders").trigger();
        QVERIFY(view.colliders().empty());
    }

    // Numbers by the fields; what is out of range is brought into it, and a stop at its end is none.
    void massStopsAndSpringAreTyped() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        choose(program, QStringLiteral("piston"));
        program.command("body-slider").trigger();
        program.type(QStringLiteral("body-mass"), QStringLiteral("250"));
        program.type(QStringLiteral("slider-high"), QStringLiteral("20"));
        program.type(QStringLiteral("slider-spring"), QStringLiteral("300"));
        const Scene& scene = program.document.scene();
        const BodyId body = scene.mechanics.bodies[0].id;
        QCOMPARE(scene.mechanics.bodies[0].mass, 0.25);
        auto joint = axisJointOf(scene, body);
        QVERIFY(joint);
        COMPARE_NEAR(joint->high, 0.02, 1e-12, "m");
        QVERIFY(joint->low == -kUnbounded);
        QCOMPARE(joint->stiffness, 300.0);
        program.type(QStringLiteral("slider-high"), QStringLiteral("1000"));
        QVERIFY(axisJointOf(scene, body)->high == kUnbounded);
        program.command("body-still").trigger();
        QVERIFY(scene.mechanics.bodies.empty() && scene.mechanics.colliders.empty());
        program.command("undo").trigger();
        QCOMPARE(scene.mechanics.bodies[0].mass, 0.25);
    }

    // On the model: the tip of the axis turns it and snaps to the world's axes, the end of the arc is a stop.
    void theJointIsDraggedOnTheModel() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        choose(program, QStringLiteral("wheel"));
        program.command("body-hinge").trigger();
        push(program, "axis-z");
        const SceneView& view = program.window->view();
        QVERIFY(view.joint().mark());
        const auto placeOf = [&](JointHandle handle) {
            return view.joint().placeOf(handle, view.camera())->toPoint();
        };
        const auto jointNow = [&] {
            const Scene& scene = program.document.scene();
            return axisJointOf(scene, scene.mechanics.bodies[0].id).value();
        };
        const auto drag = [&](JointHandle handle, QPoint by) {
            const QPoint from = placeOf(handle);
            program.press(from);
            program.moveTo(from + by / 2);
            program.moveTo(from + by);
            program.release(from + by);
        };
        const int steps = program.document.history().count();
        QVERIFY(jointNow().high == kUnbounded);
        const QPoint end = placeOf(JointHandle::High);
        drag(JointHandle::High, QPoint(4, -12));
        QCOMPARE(program.document.history().count(), steps + 1); // one step, however many moves
        QVERIFY(jointNow().high < kUnbounded && jointNow().high > 0);
        const QPoint now = placeOf(JointHandle::High);
        QVERIFY2((now - end - QPoint(4, -12)).manhattanLength() < 40, "it follows the pointer");
        const Vec3 before = jointNow().at;
        drag(JointHandle::Place, QPoint(30, 0));
        QCOMPARE_GT((jointNow().at - before).norm(), 1e-3);
        drag(JointHandle::Tip, QPoint(2, 1));
        COMPARE_NEAR(jointNow().axis, Vec3(Vec3::UnitZ()), 1e-12, ""); // it snaps back
        drag(JointHandle::Tip, QPoint(60, -60));
        QCOMPARE_LT(jointNow().axis.z(), 0.99);
        keep(program, "joint");
        giveUpADrag(program, placeOf(JointHandle::Place));
        auto* body = program.window->findChild<QDockWidget*>(QStringLiteral("dock-body"));
        program.window->findChild<QDockWidget*>(QStringLiteral("dock-layers"))->raise();
        QTRY_VERIFY_WITH_TIMEOUT(!view.joint().mark(), kPatience); // as those of the panel in front
        body->raise();
        QTRY_VERIFY_WITH_TIMEOUT(view.joint().mark(), kPatience);
        choose(program, QStringLiteral("base"));
        QVERIFY(!view.joint().mark());
    }

    // Time runs while a scene is made: a person is told what has been let go, and how to have it back.
    void whatIsLetGoIsToldAndComesBack() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        choose(program, QStringLiteral("piston"));
        const auto told = [text = program.window->findChild<QLabel*>(QStringLiteral("notice-text"))] {
            return text->isVisible() ? text->text() : QString();
        };
        const auto moved = [&] {
            const auto world = compile(program.document.scene()).value();
            BodyPlaces places(world.get());
            double farthest = 0;
            for (const PlacedObject& placed : places.at(program.engine.proxy().bodies))
                farthest = std::max(farthest, placed.pose.translation.norm());
            return farthest;
        };
        program.command("body-loose").trigger();
        QCOMPARE(told(), QStringLiteral("piston moves from now on, as time runs."));
        QTRY_VERIFY_WITH_TIMEOUT(moved() > 0.01, kPatience);
        QTest::mouseClick(program.window->findChild<QPushButton*>(QStringLiteral("notice-act")),
                          Qt::LeftButton);
        QVERIFY(!program.command("motion-run").isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(moved() < 1e-9, kPatience);
        // What moves already, and what cannot while time stands, is no news.
        program.command("body-slider").trigger();
        QCOMPARE(told(), QString());
        choose(program, QStringLiteral("rod"));
        program.command("body-loose").trigger();
        QCOMPARE(told(), QString());
    }

    // A removed object leaves nothing behind that others would meet.
    void whatIsRemovedIsMetByNobody() {
        TouchedWindow program({1400, 1000});
        QVERIFY(program.open(writeCrank(folder_)));
        choose(program, QStringLiteral("piston"));
        program.command("body-loose").trigger();
        const Scene& scene = program.document.scene();
        const std::size_t colliders = scene.mechanics.colliders.size();
        program.document.removeObject(scene.objects[2].id);
        QCOMPARE(scene.mechanics.colliders.size(), colliders - 1);
        program.document.removeObject(scene.objects.back().id);
        QVERIFY(scene.mechanics.bodies.empty());
    }
};

TACTUM_GUI_TEST(TestBodyPanel)

} // namespace test_body_panel

#include "test_body_panel.moc"
