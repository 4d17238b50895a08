// Panels of how an object moves and where it is: what they show of each way to be held, and what each of
// their fields changes. Wrong itself if a figure of the scene were missing in mechanicsOf() or placesOf(): an
// edit of it would say nothing.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "core/motion/motion_build.h"
#include "core/scene/bodies.h"
#include "core/scene/colliders.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/panels/panels.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/place_panel.h"
#include "ui/tools/arrange_tool.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/number_box.h"

namespace test_motion_panels {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

QString text(double value) {
    return QString::number(std::abs(value) < 1e-12 ? 0 : value, 'g', 5); // no -0
}
QString text(const Vec3& v) {
    return QStringLiteral("(%1 %2 %3)").arg(text(v.x()), text(v.y()), text(v.z()));
}

/// Each figure of what moves, in a line.
QStringList mechanicsOf(const Scene& scene) {
    QStringList lines{QStringLiteral("gravity ") + text(scene.mechanics.gravity)};
    for (const WorldField& field : kWorldFields)
        lines << QString::fromUtf8(field.parameter->key.data()) + u' ' + text(scene.mechanics.*field.value);
    for (const RigidBody& body : scene.mechanics.bodies) {
        const QString name = QStringLiteral("body %1 ").arg(body.id);
        lines << name + QStringLiteral("mass ") + text(body.mass)
              << name + QStringLiteral("inertia ") + text(body.inertia)
              << name + QStringLiteral("centre ") + text(body.pose.apply(body.centre))
              << name + QStringLiteral("gravity ") + text(body.gravityFactor);
        for (std::size_t i = 0; i < jointsOf(scene, body.id); ++i) {
            const auto joint = axisJointOf(scene, body.id, i);
            const QString held = QStringLiteral("joint %1 of body %2 ").arg(i + 1).arg(body.id);
            if (!joint) {
                lines << held + QStringLiteral("of another kind");
                continue;
            }
            lines << held + QStringLiteral("kind ") + QString::number(int(joint->kind))
                  << held + QStringLiteral("to ") + QString::number(joint->to)
                  << held + QStringLiteral("at ") + text(joint->at)
                  << held + QStringLiteral("axis ") + text(joint->axis)
                  << held + QStringLiteral("closed ") + QString::number(joint->path.closed);
            for (const AxisField& field : kAxisFields)
                lines << held + QString::fromUtf8(field.of(joint->kind).key.data()) + u' ' +
                             text(*joint.*field.value);
            for (const Vec3& point : joint->path.points)
                lines << held + QStringLiteral("point ") + text(point);
        }
    }
    for (const SceneObject& object : scene.objects) {
        const auto form = colliderFormOf(scene, object.id);
        lines << QStringLiteral("%1 body %2 met as %3")
                     .arg(QString::fromStdString(object.name))
                     .arg(object.body)
                     .arg(form ? QString::number(int(*form)) : QStringLiteral("none"));
    }
    return lines;
}

/// Where and how large each object is.
QStringList placesOf(const Scene& scene) {
    QStringList lines;
    for (const SceneObject& object : scene.objects) {
        const Bounds box = boundsOf(*object.geometry);
        const QString name = QString::fromStdString(object.name) + u' ';
        lines << name + QStringLiteral("middle ") + text(object.pose.apply(box.centre()))
              << name + QStringLiteral("sides ") + text(Vec3(box.high - box.low))
              << name + QStringLiteral("turned ") + text(anglesOf(object.pose.rotation));
    }
    return lines;
}

/// What each act changed, and how the history calls it.
class Changes {
public:
    Changes(Document& document, QStringList (*figures)(const Scene&))
        : document_(document), figures_(figures) {}

    template <class Act> void note(const QString& what, const Act& act) {
        const QStringList before = figures_(document_.scene());
        const int steps = document_.history().index();
        act();
        QApplication::processEvents();
        const QStringList after = figures_(document_.scene());
        const int more = document_.history().index() - steps;
        text_ += what + QStringLiteral(": ") +
                 (more == 0 ? QStringLiteral("no step") : u'"' + document_.history().undoText() + u'"') +
                 (more > 1 ? QStringLiteral(" and %1 more").arg(more - 1) : QString()) + u'\n';
        text_ += changedLines(before, after);
    }
    const QString& text() const { return text_; }

private:
    Document& document_;
    QStringList (*figures_)(const Scene&);
    QString text_;
};

SceneObject boxNamed(const char* name, const Vec3& size, const Vec3& at) {
    SceneObject object;
    object.name = name;
    object.geometry = std::make_shared<const TriangleSoup>(test::box(size));
    object.pose.translation = at;
    object.surfaces.resize(1);
    object.surfaces[0].name = "side";
    return object;
}

/// A lid beside a box, a stand, and a plate that moves by its keys.
Scene lidAndBox() {
    Scene scene;
    scene.add(boxNamed("Lid", {0.1, 0.01, 0.06}, {0, 0.055, 0}));
    scene.add(boxNamed("Chest", {0.1, 0.1, 0.06}, {0, 0, 0}));
    SceneObject moving = boxNamed("Plate", {0.04, 0.01, 0.04}, {0.2, 0, 0});
    const Track<Vec3> aside{Interpolation::Linear, {0, 2}, {Vec3::Zero(), {0, 0.05, 0}}, {}, {}};
    moving.motion = std::make_shared<const Motion>(makeMotion(aside, {}, 2));
    scene.add(moving);
    return scene;
}

void chooseObject(Document& document, std::size_t index) {
    document.selectObjects({document.scene().objects[index].id});
    QApplication::processEvents();
}

/// Seven notches of its wheel; downwards where it stands at its end.
void turnSeven(QWidget& panel, const std::string& name) {
    auto& box = part<NumberBox>(panel, name.c_str());
    const double way = 7 * box.singleStep();
    box.setValue(box.value() + (box.value() + way > box.maximum() ? -way : way));
}

struct Panel {
    explicit Panel(const Scene& scene) {
        adopt(document, scene);
        body.resize(320, 900);
        body.show();
        if (!QTest::qWaitForWindowExposed(&body)) qFatal("no window");
    }
    void click(const char* name) { part<QToolButton>(body, name).click(); }
    void choose(const char* name, int row) {
        auto& box = part<QComboBox>(body, name);
        box.setCurrentIndex(row);
        emit box.activated(row);
    }
    QString shown() { return shownIn(body); }

    Document document;
    BodyPanel body{document};
};

} // namespace

class TestMotionPanels : public QObject {
    Q_OBJECT

public:
    static void initMain() { namePanelTest("TactumMotionPanels"); }

private slots:
    void initTestCase() {
        speakEnglish();
        applyTheme(ThemeChoice::Dark);
    }

    void itShowsHowAnObjectIsHeld() {
        Panel panel(lidAndBox());
        COMPARE_SHOWN(panel.shown(), "body");
        States states(panel.shown());
        const auto then = [&](const char* name) {
            panel.click(name);
            states.note(QLatin1String(name), panel.shown());
        };
        chooseObject(panel.document, 0);
        states.note(QStringLiteral("still"), panel.shown());
        for (const char* name :
             {"hold-loose", "hold-hinge", "joint-add", "joint-remove", "hold-slider", "hold-path"})
            then(name);
        chooseObject(panel.document, 1); // what the lid lies on
        states.note(QStringLiteral("beside"), panel.shown());
        panel.document.select({});
        states.note(QStringLiteral("world"), panel.shown());
        COMPARE_SHOWN(states.text(), "body-states");
    }

    void aJointOfAnotherKindIsLeftAsItIs() {
        Scene scene = lidAndBox();
        const BodyId lid = makeBody(scene, scene.objects[0].id);
        setAxisJoint(scene, lid, guessedJoint(scene, lid, AxisKind::Hinge));
        scene.mechanics.joints[0].limits.clear(); // all is free
        QVERIFY(!axisJointOf(scene, lid));
        Panel panel(scene);
        chooseObject(panel.document, 0);
        const auto& others = part<QLabel>(panel.body, "other-joints");
        QVERIFY(others.isVisible());
        COMPARE_CONTAINS(others.text(), "1 joint of another kind");
        QVERIFY(!part<QWidget>(panel.body, "joint-which").isVisible());
        chooseObject(panel.document, 1);
        QVERIFY(!others.isVisible());
    }

    void whatIsMetAsSeveralFormsIsSaid() {
        Scene scene = lidAndBox();
        makeBody(scene, scene.objects[0].id);
        Panel panel(scene);
        chooseObject(panel.document, 0);
        auto& form = part<QComboBox>(panel.body, "collider-form");
        QCOMPARE(form.currentText(), "One hull");
        panel.document.editBodies(QStringLiteral("One more"), [](Scene& edited) {
            auto& colliders = edited.mechanics.colliders;
            Collider beside = *std::ranges::find(colliders, edited.mechanics.bodies[0].id, &Collider::body);
            beside.shape.kind = ShapeKind::Box;
            colliders.push_back(beside);
        });
        QCOMPARE(form.currentText(), "");
        QCOMPARE(form.placeholderText(), "None of these, or several");
    }

    void itSaysWhyNothingIsHeld() {
        Panel panel(lidAndBox());
        QSignalSpy failed(&panel.body, &BodyPanel::failed), freed(&panel.body, &BodyPanel::freed);
        panel.body.hold(BodyPanel::Hold::Hinge);
        QCOMPARE(failed.takeFirst()[0].toString(), "Nothing is selected; select the object first (Q).");
        chooseObject(panel.document, 2);
        panel.click("hold-loose");
        QCOMPARE(failed.takeFirst()[0].toString(), "Plate moves by its keys; it cannot be pushed.");
        QVERIFY(part<QToolButton>(panel.body, "hold-still").isChecked());
        QCOMPARE_EQ(panel.document.history().count(), 0);
        QCOMPARE_EQ(freed.count(), 0);
        chooseObject(panel.document, 0);
        panel.click("hold-loose");
        QCOMPARE(freed.takeFirst()[0].toString(), "Lid");
        panel.click("hold-hinge");
        panel.click("hold-hinge"); // as it is
        QCOMPARE_EQ(panel.document.history().count(), 2);
        QCOMPARE_EQ(freed.count(), 0);
    }

    void eachFieldChangesItsFigureAlone() {
        Panel panel(lidAndBox());
        Document& document = panel.document;
        const QStringList first = mechanicsOf(document.scene());
        Changes changes(document, mechanicsOf);
        const auto fields = [&](AxisKind kind) {
            for (const AxisField& field : kAxisFields) {
                const std::string key(field.of(kind).key);
                changes.note(QString::fromStdString(key), [&] { turnSeven(panel.body, key); });
            }
        };
        const auto click = [&](const char* name) {
            changes.note(QString::fromLatin1(name), [&] { panel.click(name); });
        };
        const auto choose = [&](const char* name, int row) {
            changes.note(QStringLiteral("%1 %2").arg(QLatin1String(name)).arg(row),
                         [&] { panel.choose(name, row); });
        };
        chooseObject(document, 0);
        click("hold-loose");
        for (const BodyField& field : kBodyFields)
            changes.note(QString::fromUtf8(field.parameter->key.data()),
                         [&] { turnSeven(panel.body, std::string(field.parameter->key)); });
        for (int row = 0; row < int(kColliderForms.size()); ++row)
            choose("collider-form", row);
        click("hold-hinge");
        for (const char* name : {"axis-x", "axis-y", "axis-z", "axis-guess", "axis-guess"})
            click(name);
        for (const char* name : {"joint-x", "joint-y", "joint-z"})
            changes.note(QString::fromLatin1(name), [&] { turnSeven(panel.body, name); });
        fields(AxisKind::Hinge);
        changes.note(QStringLiteral("the upper stop at its end"), [&] {
            auto& box = part<NumberBox>(panel.body, std::string(kAxisFields[1].hinge->key).c_str());
            box.setValue(box.maximum());
        });
        click("joint-add");
        choose("joint-which", 0);
        click("axis-x");
        choose("joint-which", 1);
        click("joint-remove");
        click("hold-slider");
        fields(AxisKind::Slider);
        click("hold-path");
        changes.note(QStringLiteral("a point more"), [&] {
            auto points = panel.body.path()->points;
            points.push_back(points.back() + Vec3(0.02, 0.01, 0));
            panel.body.setPath(points, 0);
        });
        part<QCheckBox>(panel.body, "path-closed").click();
        click("path-fewer");
        click("path-fewer"); // two are the fewest
        changes.note(QStringLiteral("points in one place"), [&] {
            panel.body.setPath({Vec3::Zero(), Vec3::Zero()}, 0);
        });
        panel.click("path-pick");
        changes.note(QStringLiteral("picked"), [&] {
            for (const Vec3& at : {Vec3(0, 0.1, 0), Vec3(0.1, 0.1, 0), Vec3(0.1, 0.1, 0.1)})
                panel.body.addPathPoint(at);
        });
        click("hold-still");
        COMPARE_SHOWN(changes.text(), "body-edits");
        while (document.history().canUndo())
            document.history().undo();
        QCOMPARE(mechanicsOf(document.scene()), first);
    }

    void theWorldsFieldsChangeTheWorld() {
        Scene scene = lidAndBox();
        makeBody(scene, scene.objects[0].id);
        Panel panel(scene);
        Changes changes(panel.document, mechanicsOf);
        for (const char* name :
             {"gravity-x", "gravity-y", "gravity-z", "air-density", "force-scale", "time-scale"})
            changes.note(QString::fromLatin1(name), [&] { turnSeven(panel.body, name); });
        COMPARE_SHOWN(changes.text(), "world-edits");
    }

    void thePlacePanelShowsAndChangesPlaces() {
        Document document;
        SceneView view;
        ArrangeTool tool(document, view);
        PlacePanel panel(document, tool);
        static_cast<QWidget&>(panel).resize(320, 500);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        COMPARE_SHOWN(shownIn(panel), "place");
        States states(shownIn(panel));
        adopt(document, lidAndBox());
        chooseObject(document, 0);
        states.note(QStringLiteral("one"), shownIn(panel));
        const QStringList first = placesOf(document.scene());
        Changes changes(document, placesOf);
        for (const char* name :
             {"place-x", "place-y", "place-z", "turn-x", "turn-y", "turn-z", "longest-side", "scale"})
            changes.note(QString::fromLatin1(name), [&] { turnSeven(panel, name); });
        // What was typed is what is shown, where several angles would do.
        part<NumberBox>(panel, "turn-y").setValue(90);
        part<NumberBox>(panel, "turn-x").setValue(30);
        COMPARE_NEAR(part<NumberBox>(panel, "turn-x").value(), 30.0, 1e-6, "degrees");
        COMPARE_NEAR(part<NumberBox>(panel, "turn-y").value(), 90.0, 1e-6, "degrees");
        chooseObject(document, 1);
        chooseObject(document, 0); // from now on as they are read off
        COMPARE_NEAR(part<NumberBox>(panel, "turn-x").value(), 0.0, 1e-6, "degrees");
        COMPARE_NEAR(part<NumberBox>(panel, "scale").value(), 1.0, 1e-9, "times");
        document.selectObjects({document.scene().objects[1].id, document.scene().objects[0].id});
        changes.note(QStringLiteral("place-x of two"), [&] { turnSeven(panel, "place-x"); });
        states.note(QStringLiteral("two"), shownIn(panel));
        COMPARE_SHOWN(states.text(), "place-states");
        COMPARE_SHOWN(changes.text(), "place-edits");
        while (document.history().canUndo())
            document.history().undo();
        QCOMPARE(placesOf(document.scene()), first);
    }
};

TACTUM_GUI_TEST(TestMotionPanels)

} // namespace test_motion_panels

#include "test_motion_panels.moc"
