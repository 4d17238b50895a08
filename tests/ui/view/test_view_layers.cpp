// What the view adds to the model: sizes, places, colours and words of a touch, of paths and of what is felt.
#include <cmath>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QTest>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "core/haptics/compile.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "tests/ui/view/props.h"
#include "ui/base/hand_colours.h"
#include "ui/base/style.h"
#include "ui/view/axes_gizmo.h"
#include "ui/view/brush_ring.h"
#include "ui/view/colour_map.h"
#include "ui/view/face_layer.h"
#include "ui/view/friction_cone.h"
#include "ui/view/mark_layer.h"
#include "ui/view/normal_glyphs.h"
#include "ui/view/path_layer.h"
#include "ui/view/scale_bar.h"
#include "ui/view/sphere_layer.h"
#include "ui/view/sphere_mesh.h"
#include "ui/view/touch_overlay.h"
#include "ui/view/touch_shape.h"
#include "ui/view/trail_layer.h"
#include "ui/view/view_labels.h"
#include "ui/view/view_stage.h"

namespace test_view_layers {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// From the front; a pixel at the origin is half a millimetre.
ViewCamera camera() {
    ViewCamera c;
    c.size = {800, 600};
    c.fieldOfView = 0.6;
    c.distance = 0.15 / std::tan(0.3);
    return c;
}

/// Both renderers of an overlay, in no window.
struct Stage {
    vtkNew<vtkRenderer> solid, ghost;
    QString props() {
        return QStringLiteral("solid\n") + propsOf(*solid) + QStringLiteral("ghost\n") + propsOf(*ghost);
    }
};

/// A finger 10 mm beneath a proxy on a plane, pushed with half of the device's 8 N.
TouchState touched() {
    TouchState state;
    state.finger = {0, -0.01, 0};
    state.force = {0, 4, 0};
    state.forceLimit = 8;
    state.armed = true;
    state.contacts = 2;
    state.contact[0] = {.point = {0, -0.001, 0}, .normal = Vec3::UnitY(), .normalForce = 3};
    state.contact[0].staticFriction = 0.8;
    state.contact[0].dynamicFriction = 0.5;
    state.contact[1] = {.point = {0.001, 0, 0}, .normal = -Vec3::UnitX(), .normalForce = 1, .slipping = true};
    return state;
}

QImage painted(QSize size, const std::function<void(QPainter&)>& paint) {
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paint(painter);
    return image;
}

bool isLike(const QColor& a, const QColor& b, int most = 40) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <=
           most;
}

/// Of the pixels that are not empty.
QRect inkOf(const QImage& image) {
    QRect box;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).alpha() > 0) box |= QRect(x, y, 1, 1);
    return box;
}

std::shared_ptr<const World> ballWorld(double stiffness = 800) {
    Scene scene = ballScene(16, 8);
    scene.objects[0].surfaces[0].material.stiffness = stiffness;
    return compile(scene).value();
}

TracePoint tracedAt(double t, double x, bool touching = true) {
    TracePoint point;
    point.t = t;
    point.proxy = {x, 0, 0};
    point.touching = touching;
    return point;
}

} // namespace

class TestViewLayers : public QObject {
    Q_OBJECT
public:
    static void initMain() {
        QCoreApplication::setOrganizationName(QStringLiteral("TactumTest"));
        QCoreApplication::setApplicationName(QStringLiteral("TactumLayers"));
    }

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }

    void aTouchIsDrawn() {
        Stage stage;
        TouchOverlay overlay(*stage.solid, *stage.ghost);
        COMPARE_SHOWN(stage.props(), "touch-none");
        overlay.setVisible(true);
        overlay.update(touched(), camera(), 0.001);
        COMPARE_SHOWN(stage.props(), "touch");
        overlay.setStylus(true); // its point is the proxy
        overlay.update(touched(), camera(), 0.001);
        COMPARE_SHOWN(stage.props(), "touch-stylus");
        overlay.setStylus(false);
        // The border of rate control is a ball about the workspace, and goes with it.
        TouchState reaching = touched();
        reaching.centre = {0.02, 0, 0};
        reaching.shell = 0.03;
        overlay.update(reaching, camera(), 0.001);
        COMPARE_SHOWN(stage.props(), "touch-shell");
        overlay.update(touched(), camera(), 0.001);
        TouchState state = touched();
        state.armed = false;
        state.contact[0].frictionless = true;
        state.finger = {0, -0.0009, 0}; // less than two pixels: no spring
        overlay.setMarks(false, true);
        overlay.update(state, camera(), 0.02); // a proxy of its true size
        COMPARE_SHOWN(stage.props(), "touch-unarmed");
        state.force = {0, 8, 0};
        state.contacts = 0;
        overlay.setMarks(true, false);
        overlay.update(state, camera(), 0.001);
        COMPARE_SHOWN(stage.props(), "touch-limit");
        overlay.setVisible(false);
        COMPARE_SHOWN(stage.props(), "touch-none");
        overlay.update(touched(), camera(), 0.001); // as long as it is hidden
        COMPARE_SHOWN(stage.props(), "touch-none");
        Stage light;
        TouchOverlay other(*light.solid, *light.ghost);
        other.setTheme(kLightTheme);
        other.setVisible(true);
        other.update(touched(), camera(), 0.001);
        COMPARE_SHOWN(light.props(), "touch-light");
    }

    /// 240 pixels at the limit, in proportion below it, never less than 22 and never more.
    void theArrowIsAsLongAsTheForce() {
        const double pixel = camera().pixelSize(Vec3::Zero());
        COMPARE_NEAR(pixel, 0.0005, 1e-12, "m");
        for (const auto& [force, pixels] :
             {std::pair(8.0, 240.0), {80.0, 240.0}, {4.0, 120.0}, {0.1, 22.0}}) {
            TouchState state = touched();
            state.force = {force, 0, 0};
            COMPARE_NEAR(arrowTip(state, camera()), Vec3(pixels * pixel, 0, 0), 1e-9, "m");
        }
    }

    void theNewestOfBothLoopsCounts() {
        ProxyTelemetry proxy;
        ServoTelemetry servo;
        proxy.finger = {1, 0, 0};
        proxy.output.proxy = {2, 0, 0};
        proxy.output.force = {3, 0, 0};
        proxy.output.contacts = 99;
        servo.finger = {4, 0, 0};
        servo.force = {5, 0, 0};
        TouchState state = touchState(proxy, servo, 0, true);
        QCOMPARE(state.finger.x(), 1.0); // no tick yet
        QCOMPARE(state.proxy.x(), 1.0);  // nor an update
        QCOMPARE(state.force.x(), 3.0);
        QCOMPARE(state.forceLimit, 1.0);
        QCOMPARE(state.contacts, kMaxModelPlanes);
        proxy.updates = servo.ticks = 1;
        state = touchState(proxy, servo, 8, true);
        QCOMPARE(state.finger.x(), 4.0);
        QCOMPARE(state.proxy.x(), 2.0);
        QCOMPARE(state.force.x(), 5.0);
        QCOMPARE(state.forceLimit, 8.0);
        QVERIFY(state.armed);
        state = touchState(proxy, servo, 8, false);
        QCOMPARE(state.force.x(), 3.0); // that would be sent
        QVERIFY(!state.armed);
        proxy.output.contacts = -1;
        QCOMPARE(touchState(proxy, servo, 8, true).contacts, 0);
        state.force = {7.99, 0, 0};
        QVERIFY(!state.atLimit());
        state.force = {7.993, 0, 0};
        QVERIFY(state.atLimit());
        state.force = {4e-4, 0, 0};
        QVERIFY(!state.pushes());
        state.force = {6e-4, 0, 0};
        QVERIFY(state.pushes());
    }

    void whatCannotBeSeenIsTheSame() {
        const TouchState state = touched();
        const auto like = [&](auto change) {
            TouchState other = touched();
            change(other);
            return state.looksLike(other, 1e-4) && other.looksLike(state, 1e-4);
        };
        QVERIFY(like([](TouchState&) {}));
        QVERIFY(like([](TouchState& s) { s.finger.x() += 0.9e-4; }));
        QVERIFY(!like([](TouchState& s) { s.finger.x() += 1.1e-4; }));
        QVERIFY(!like([](TouchState& s) { s.proxy.y() += 1.1e-4; }));
        QVERIFY(like([](TouchState& s) { s.force.y() += 4e-3; }));
        QVERIFY(!like([](TouchState& s) { s.force.y() += 6e-3; }));
        QVERIFY(!like([](TouchState& s) { s.force.setZero(); }));
        QVERIFY(!like([](TouchState& s) { s.armed = false; }));
        QVERIFY(!like([](TouchState& s) { s.forceLimit = 9; }));
        QVERIFY(!like([](TouchState& s) { s.contacts = 1; }));
        QVERIFY(!like([](TouchState& s) { s.contact[1].slipping = false; }));
        QVERIFY(!like([](TouchState& s) { s.contact[1].frictionless = true; }));
        QVERIFY(!like([](TouchState& s) { s.contact[1].point.z() += 1.1e-4; }));
        QVERIFY(!like([](TouchState& s) { s.contact[1].normal = Vec3(-1, 0.003, 0).normalized(); }));
        QVERIFY(like([](TouchState& s) { s.contact[1].normal = Vec3(-1, 0.001, 0).normalized(); }));
        QVERIFY(like([](TouchState& s) { s.contact[2].slipping = true; })); // there is no third
        TouchState small = touched(), turned = touched();
        small.force = {0, 0.1, 0};
        turned.force = {0.0004, 0.1, 0};
        QVERIFY(small.looksLike(turned, 1e-4));
        turned.force = {0.0006, 0.1, 0}; // of small forces less is seen
        QVERIFY(!small.looksLike(turned, 1e-4));
    }

    void theConeOfFriction() {
        Stage stage;
        FrictionCone cone(*stage.solid, *stage.ghost);
        cone.update(touched(), camera());
        COMPARE_SHOWN(stage.props(), "cone-none");
        cone.setVisible(true);
        cone.update(touched(), camera());
        COMPARE_SHOWN(stage.props(), "cone-sticks");
        TouchState state = touched();
        state.contact[0].slipping = true;
        state.force = {0, 0.01, 0}; // at least 56 pixels high
        cone.update(state, camera());
        COMPARE_SHOWN(stage.props(), "cone-slips");
        state = touched();
        state.contact[0].dynamicFriction = 0.7999; // hardly narrower
        cone.update(state, camera());
        QCOMPARE(stage.props().count(QStringLiteral("hidden")), 2);
        state.contact[0].staticFriction = 0;
        cone.update(state, camera());
        COMPARE_SHOWN(stage.props(), "cone-none");
        state = touched();
        state.force.setZero();
        cone.update(state, camera());
        COMPARE_SHOWN(stage.props(), "cone-none");
        state.contacts = 0;
        QVERIFY(!mainContact(state));
        QCOMPARE(mainContact(touched())->normalForce, 3.0);
    }

    void anArrowHasAShaftAndAHead() {
        Stage stage;
        TouchArrow arrow(*stage.solid, *stage.ghost);
        arrow.setColour(Qt::red, 0.5);
        arrow.place({1, 2, 3}, {1, 2, 13}, 0.5, 1, 4);
        COMPARE_SHOWN(stage.props(), "arrow");
        arrow.place({0, 0, 0}, {1, 0, 0}, 0.5, 1, 4); // a short one is all head
        COMPARE_SHOWN(stage.props(), "arrow-short");
        arrow.setVisible(false);
        QCOMPARE(stage.props().count(QStringLiteral("hidden")), 4);
    }

    void theTrailFades() {
        Stage stage;
        TrailLayer trail(*stage.solid, *stage.ghost);
        HapticOutput slips;
        slips.contacts = 1;
        slips.contact[0].slipping = true;
        HapticOutput sticks = slips;
        sticks.contact[0].slipping = false;
        const std::vector<TracePoint> first{tracedAt(0, 0), tracedAt(0.01, 0.001), tracedAt(0.02, 0.002)};
        trail.add(first, slips);
        QVERIFY(!trail.fades()); // not shown: nothing is kept
        COMPARE_SHOWN(stage.props(), "trail-hidden");
        trail.setVisible(true);
        trail.add(first, slips);
        QVERIFY(trail.fades());
        const std::vector<TracePoint> rests{tracedAt(0.03, 0.00201), tracedAt(0.09, 0.00201),
                                            tracedAt(0.15, 0.00201), tracedAt(0.16, 0.004, false)};
        trail.add(rests, sticks);
        trail.update(2);
        COMPARE_SHOWN(stage.props(), "trail");
        vtkActorCollection* actors = stage.solid->GetActors();
        actors->InitTraversal();
        auto* data = vtkPolyDataMapper::SafeDownCast(actors->GetNextActor()->GetMapper())->GetInput();
        auto* colours = vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetScalars());
        const auto colourAt = [&](vtkIdType i) {
            unsigned char rgba[4];
            colours->GetTypedTuple(i, rgba);
            return QColor(rgba[0], rgba[1], rgba[2], rgba[3]);
        };
        QCOMPARE(data->GetNumberOfPoints(), 5);
        for (const int i : {0, 1, 2})
            QCOMPARE(colourAt(i).rgb(), kDarkTheme.slip.rgb());
        QCOMPARE(colourAt(3).rgb(), kDarkTheme.textDimmed.rgb()); // free
        QCOMPARE(colourAt(4).rgb(), kDarkTheme.stick.rgb());      // the bead
        QCOMPARE(colourAt(0).alpha(), int(255 * (1 - 0.16 / 4)));
        QCOMPARE(colourAt(4).alpha(), int(255 * (1 - (0.16 - 0.02 - 0.13) / 4)));
        QCOMPARE(colourAt(3).alpha(), 255);
        // Four seconds are kept; a gap of a tenth begins anew, and so does time that goes back.
        std::vector<TracePoint> longer;
        for (int i = 0; i <= 500; ++i)
            longer.push_back(tracedAt(0.17 + 0.01 * i, 0.01 + 0.001 * i));
        trail.add(longer, slips);
        trail.update(1);
        QCOMPARE(data->GetNumberOfPoints(), 401);
        const std::vector<TracePoint> later{tracedAt(5.3, 1)}, back{tracedAt(1, 2)};
        trail.add(later, slips);
        trail.update(1);
        QCOMPARE(data->GetNumberOfPoints(), 1);
        QVERIFY(!trail.fades());
        trail.add(longer, slips);
        trail.add(back, slips);
        trail.update(1);
        QCOMPARE(data->GetNumberOfPoints(), 1);
        trail.setVisible(false);
        trail.setVisible(true);
        trail.update(1);
        QCOMPARE(data->GetNumberOfPoints(), 0);
    }

    void pathsOfATouch() {
        Stage stage;
        TouchTrace rows;
        for (int i = 0; i <= 200; ++i)
            rows.push_back({.t = 1e-3 * i,
                            .finger = {5e-4 * i, -0.01, 0},
                            .proxy = {5e-4 * i, 0, 0},
                            .force = {0, i < 100 ? 0.0 : 0.02 * (i - 100), 0}});
        {
            PathLayer layer(*stage.solid, *stage.ghost, rows, camera(), kDarkTheme);
            COMPARE_SHOWN(stage.props(), "paths");
        }
        Stage still;
        for (TouchRow& row : rows)
            row.force.setZero();
        PathLayer layer(*still.solid, *still.ghost, rows, camera(), kDarkTheme);
        QCOMPARE(propsOf(*still.solid).count(u'\n'), 2); // both lines and no arrow
    }

    void markedAndSelectedTriangles() {
        Stage stage;
        const auto ball = ballSoup(16, 8);
        MarkLayer marks(*stage.solid, *stage.ghost);
        QVERIFY(!marks.any());
        marks.setColour(Qt::red);
        marks.show(ball.get(), {0, 5, 7}, {Quat(0, 1, 0, 0), {1, 2, 3}});
        QVERIFY(marks.any());
        COMPARE_SHOWN(stage.props(), "marks");
        marks.show(ball.get(), {}, {});
        QVERIFY(!marks.any());
        QCOMPARE(stage.props().count(QStringLiteral("hidden")), 2);
        marks.show(nullptr, {1}, {});
        QVERIFY(!marks.any());
        Stage other;
        FaceLayer faces(*other.solid);
        faces.setTheme(kDarkTheme);
        QCOMPARE(propsOf(*other.solid), "hidden\n");
        const std::vector<Index> some{0, 1, 2};
        faces.show(ball, some);
        vtkNew<vtkMatrix4x4> matrix;
        matrix->SetElement(0, 3, 5);
        faces.place(matrix);
        COMPARE_SHOWN(propsOf(*other.solid), "faces");
        faces.place(nullptr);
        QCOMPARE(propsOf(*other.solid), "hidden\n");
        faces.show(ball, {});
        QCOMPARE(propsOf(*other.solid), "hidden\n");
        faces.show(ball, some);
        QVERIFY(propsOf(*other.solid) != "hidden\n");
        faces.show(nullptr, some);
        QCOMPARE(propsOf(*other.solid), "hidden\n");
    }

    void spheresOfTheHierarchy() {
        const auto world = ballWorld();
        const ObjectId ball = world->bodies[0].object;
        vtkNew<vtkRenderer> renderer;
        SphereLayer layer(*renderer);
        QCOMPARE(layer.legend(), "Spheres: being read");
        QVERIFY(!layer.takeFinished());
        layer.ask(world, 0, Vec3::Zero());
        QVERIFY(layer.pending());
        QVERIFY(waitFor([&] { return layer.takeFinished(); }));
        QVERIFY(layer.shown());
        const SphereLevel made = sphereLevel(*world, 0, Vec3::Zero());
        QCOMPARE(layer.legend(),
                 QStringLiteral("Spheres at level 0 of %1: %2 (+ and -)").arg(made.deepest).arg(made.all));
        QCOMPARE(layer.deepest(), made.deepest);
        vtkNew<vtkMatrix4x4> matrix;
        matrix->SetElement(1, 3, 2);
        layer.place(ball, matrix);
        COMPARE_SHOWN(propsOf(*renderer), "spheres");
        layer.place(ball, nullptr);
        QCOMPARE(propsOf(*renderer), "hidden\n");
        layer.place(ball + 1, matrix); // nobody
        layer.ask(world, 99, Vec3::Zero());
        QVERIFY(waitFor([&] { return layer.takeFinished(); }));
        COMPARE_BEGINS(layer.legend(), QStringLiteral("Spheres at level %1 of %1: ").arg(made.deepest));
        layer.clear();
        QVERIFY(!layer.shown());
        QCOMPARE(propsOf(*renderer), "\n");
    }

    /// Each sphere of the level, as round as there is room for, its normals outward.
    void spheresAreRound() {
        const auto world = ballWorld();
        const SphereLevel level = sphereLevel(*world, 1, Vec3::Zero());
        const auto spheres = world->bodies[0].mesh->tree.spheresAt(1);
        QCOMPARE(level.all, spheres.size());
        QCOMPARE(level.drawn, spheres.size());
        QCOMPARE(level.meshes.size(), 1u);
        const SphereMesh& mesh = level.meshes[0];
        const std::size_t places = mesh.positions.size() / 3 / spheres.size();
        QCOMPARE(places, 1920u); // three times in four: 320 triangles with six places each
        QCOMPARE(mesh.triangles.size(), 3 * 1280 * spheres.size());
        for (std::size_t s = 0; s < spheres.size(); ++s)
            for (std::size_t i = 0; i < places; i += 97) {
                const std::size_t at = 3 * (s * places + i);
                const Eigen::Vector3f p(mesh.positions[at], mesh.positions[at + 1], mesh.positions[at + 2]),
                    n(mesh.normals[at], mesh.normals[at + 1], mesh.normals[at + 2]);
                COMPARE_NEAR((p - spheres[s].centre).norm(), spheres[s].radius, 1e-6, "m");
                COMPARE_NEAR((p - spheres[s].centre - spheres[s].radius * n).norm(), 0, 1e-6, "m");
            }
        // Corners counter-clockwise from outside.
        const auto at = [&](std::size_t corner) {
            const auto i = 3 * std::size_t(mesh.triangles[corner]);
            return Vec3(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
        };
        for (std::size_t t = 0; t < 1280; t += 31) {
            const Vec3 a = at(3 * t), b = at(3 * t + 1), c = at(3 * t + 2);
            QCOMPARE_GT((b - a).cross(c - a).dot(a - spheres[0].centre.cast<double>()), 0);
        }
        const auto fine = compile(ballScene(48, 24)).value();
        QCOMPARE_GT(sphereLevel(*fine, 1, Vec3::Zero()).all, sphereLevel(*fine, 0, Vec3::Zero()).all);
        QCOMPARE_EQ(sphereLevel(*world, 50, Vec3::Zero()).all,
                    sphereLevel(*world, level.deepest, Vec3::Zero()).all);
        const std::atomic<bool> cancelled = true;
        QVERIFY(sphereLevel(*world, 1, Vec3::Zero(), {{}, &cancelled}).meshes.empty());
    }

    void normalsAsNeedles() {
        const auto world = ballWorld();
        vtkNew<vtkRenderer> renderer;
        NormalGlyphs glyphs(*renderer);
        QCOMPARE(glyphs.legend(), "Normals: being read");
        glyphs.setWidth(3);
        glyphs.ask(world, 0.01);
        QVERIFY(waitFor([&] { return glyphs.takeFinished(); }));
        vtkNew<vtkMatrix4x4> matrix;
        glyphs.place(world->bodies[0].object, matrix);
        COMPARE_SHOWN(glyphs.legend() + u'\n' + propsOf(*renderer), "needles");
        glyphs.setWidth(5);
        glyphs.setTheme(kLightTheme);
        COMPARE_CONTAINS(propsOf(*renderer), "line 5");
        glyphs.place(world->bodies[0].object, nullptr);
        QCOMPARE(propsOf(*renderer), "hidden\n");
        glyphs.clear();
        QVERIFY(!glyphs.shown());
        QCOMPARE(propsOf(*renderer), "\n");
    }

    void theMapOfColours() {
        QCOMPARE(mapColour(0), QColor(68, 1, 84));
        QCOMPARE(mapColour(-1), QColor(68, 1, 84));
        QCOMPARE(mapColour(1), QColor(253, 231, 37));
        QCOMPARE(mapColour(2), QColor(253, 231, 37));
        QCOMPARE(mapColour(0.5), QColor(33, 144, 141));
        QCOMPARE(mapColour(0.0625), QColor(70, 23, 103)); // half way to the next
        QCOMPARE(mapColour(0.9375), QColor(212, 226, 44));
        for (int i = 1; i <= 100; ++i) // lightness rises
            QCOMPARE_GE(qGray(mapColour(i / 100.0).rgb()), qGray(mapColour((i - 1) / 100.0).rgb()));
    }

    void theScaleOfAMap() {
        const auto range = [](double low, double high, double unit = 1) {
            const MapRange made = rangeOf(low, high, unit);
            return std::pair(made.low, made.high);
        };
        QCOMPARE(range(2, 5), std::pair(2.0, 5.0));
        QCOMPARE(range(5, 5), std::pair(0.0, 5.0));
        QCOMPARE(range(-5, -5), std::pair(-5.0, 0.0));
        QCOMPARE(range(0, 0, 3), std::pair(0.0, 3.0));
        QCOMPARE(range(5, 5 + 1e-9), std::pair(0.0, 5.0)); // the same but for rounding
        QCOMPARE((MapRange{2, 4}.part(3)), 0.5);
        QCOMPARE((MapRange{2, 2}.part(3)), 0.0);
        QCOMPARE(wordsOf(FeltValue::Height).name, "Height of texture");
        QCOMPARE(wordsOf(FeltValue::Height).unit, "mm");
        QCOMPARE(wordsOf(FeltValue::Height).factor, 1000.0);
        const std::pair<FeltValue, const char*> names[] = {{FeltValue::Stiffness, "Stiffness N/m"},
                                                           {FeltValue::Damping, "Damping N s/m"},
                                                           {FeltValue::StaticFriction, "Static friction "},
                                                           {FeltValue::DynamicFriction, "Dynamic friction "},
                                                           {FeltValue::Viscosity, "Viscosity N s/m"}};
        for (const auto& [value, name] : names) {
            QCOMPARE(wordsOf(value).name + u' ' + wordsOf(value).unit, name);
            QCOMPARE(wordsOf(value).factor, 1.0);
        }
        QRectF box;
        const QImage image = painted({800, 600}, [&](QPainter& p) {
            box = drawScaleBar(p, QSizeF(800, 600), 100, FeltValue::Stiffness, {200, 1000}, kDarkTheme);
        });
        QCOMPARE(inkOf(image), box.toRect());
        QCOMPARE(box.left(), 12.0);
        COMPARE_NEAR(box.bottom(), 588, 1.01, "pixels");
        // The bar: 10 pixels inside, 16 wide, 176 high, dark below and light above.
        const double bottom = box.bottom() - 10 - QFontMetricsF(QApplication::font()).height() / 2;
        QVERIFY(isLike(image.pixelColor(24, int(bottom) - 6), mapColour(0.03)));
        QVERIFY(isLike(image.pixelColor(24, int(bottom - 88)), mapColour(0.5)));
        COMPARE_NEAR(image.pixelColor(24, int(bottom) - 150).red(), mapColour(150 / 175.0).red(), 30, "");
        QRectF small;
        painted({800, 600}, [&](QPainter& p) {
            small = drawScaleBar(p, QSizeF(800, 200), 100, FeltValue::Height, {0, 0.001}, kDarkTheme);
        });
        COMPARE_NEAR(box.height() - small.height(), 176 - 60, 1.01,
                     "pixels"); // it gives way, but not below 60
        COMPARE_NEAR(small.bottom(), 188, 1.01, "pixels");
    }

    void theCrossOfTheAxes() {
        ViewCamera c = camera(); // from the front: X to the right, Y up, Z into the eye
        const auto picture = [&] {
            return painted({800, 600}, [&](QPainter& p) { drawAxes(p, c, kDarkTheme); });
        };
        const QPointF centre(800 - 92 - 8 + 46, 8 + 46);
        const auto colourAt = [&](const QImage& image, QPointF from) {
            return image.pixelColor((centre + from).toPoint());
        };
        const QImage front = picture();
        QVERIFY(QRect(700, 8, 92, 92).contains(inkOf(front)));
        QVERIFY(isLike(colourAt(front, {31 + 6, 5}), kDarkTheme.axisX));
        QVERIFY(isLike(colourAt(front, {15, 0}), kDarkTheme.axisX)); // its line
        QVERIFY(isLike(colourAt(front, {6, -31 - 5}), kDarkTheme.axisY));
        QVERIFY(isLike(colourAt(front, {-6, 5}), kDarkTheme.axisZ)); // before the others
        const QColor dim = colourAt(front, {-31, 0});
        COMPARE_NEAR(dim.alphaF(), 0.45, 0.02, "");
        QVERIFY(isLike(dim, kDarkTheme.axisX));
        QCOMPARE(colourAt(front, {-31 - 6, 0}).alpha(), 0); // a small ball
        QCOMPARE(colourAt(front, {-15, 0}).alpha(), 0);     // without a line
        c.yaw = EIGEN_PI / 2;                               // from the right: X into the eye, Z to the left
        const QImage side = picture();
        QVERIFY(isLike(colourAt(side, {-31 - 6, 5}), kDarkTheme.axisZ));
        QVERIFY(isLike(colourAt(side, {-6, 5}), kDarkTheme.axisX));
    }

    void theRingOfTheBrush() {
        PickHit at;
        at.point = {0.01, 0, 0};
        at.normal = Vec3::UnitZ();
        const ViewCamera c = camera();
        const QImage image = painted({800, 600}, [&](QPainter& p) {
            drawBrushRing(p, at, {0.02, 0.5}, c, kDarkTheme);
        });
        // 40 pixels about (420, 300), and a dotted one of half of that.
        for (const QPointF& on : {QPointF(40, 0), {-40, 0}, {0, 40}, {0, -40}})
            QVERIFY(isLike(image.pixelColor((QPointF(420, 300) + on).toPoint()), kDarkTheme.accent, 160));
        QVERIFY(std::abs(inkOf(image).width() - 84) <= 2);
        QCOMPARE(image.pixelColor(420, 300).alpha(), 0);
        QCOMPARE(image.pixelColor(450, 300).alpha(), 0);
        int dotted = 0;
        for (int x = 436; x <= 444; ++x)
            for (int y = 290; y <= 310; ++y)
                dotted += image.pixelColor(x, y).alpha() > 0;
        QCOMPARE_GT(dotted, 0);
        QVERIFY(inkOf(painted({800, 600}, [&](QPainter& p) {
                    drawBrushRing(p, at, {5, 0.5}, c, kDarkTheme);
                })).isNull());
        at.point = c.eye();
        QVERIFY(inkOf(painted({800, 600}, [&](QPainter& p) {
                    drawBrushRing(p, at, {0.02, 0.5}, c, kDarkTheme);
                })).isNull());
    }

    /// Words beside what they name, and where.
    void wordsBesideATouch() {
        const auto labels = [&](const TouchState& state) {
            return drawnBy({800, 600}, [&](QPainter& p) { drawTouchLabels(p, state, camera(), kDarkTheme); });
        };
        TouchState state = touched();
        COMPARE_SHOWN(labels(state), "labels");
        state.finger = {0, -0.02, 0}; // 40 pixels apart: the finger has its name
        COMPARE_SHOWN(labels(state), "labels-finger");
        state.contact[0].frictionless = true;
        state.armed = false;
        COMPARE_SHOWN(labels(state), "labels-unarmed");
        state.force.setZero();
        state.contacts = 0;
        QCOMPARE(labels(state).count(QStringLiteral("shape filled label")), 1);
        state.finger = {0, -0.012, 0};
        QCOMPARE(labels(state), "\n");
        state = touched();
        state.proxy = camera().eye(); // nothing is seen of it
        QCOMPARE(labels(state), "\n");
    }

    /// Of several hands each has its name, also where finger and proxy are one; and its colours.
    void eachHandHasItsName() {
        const auto words = [&](auto draw) {
            return drawnBy({800, 600}, [&](QPainter& p) { draw(p); })
                .count(QStringLiteral("shape filled label"));
        };
        TouchState state = touched();
        state.contacts = 0;
        state.finger = state.proxy;
        QCOMPARE(words([&](QPainter& p) { drawTouchLabels(p, state, camera(), kDarkTheme); }), 1);
        const HandName left{0, QStringLiteral("Left")}, right{1, QStringLiteral("Right")};
        QCOMPARE(words([&](QPainter& p) { drawTouchLabels(p, state, camera(), kDarkTheme, {}, left); }), 2);
        QCOMPARE(words([&](QPainter& p) { drawHandLabels(p, state, camera(), kDarkTheme, right); }), 2);
        state.force.setZero();
        QCOMPARE(words([&](QPainter& p) { drawHandLabels(p, state, camera(), kDarkTheme, right); }), 1);
        QCOMPARE(handColours(kDarkTheme, 0).finger, kDarkTheme.finger);
        QCOMPARE(handColours(kLightTheme, 0).proxy, kLightTheme.proxy);
        for (const Theme* theme : {&kDarkTheme, &kLightTheme})
            for (std::size_t hand = 1; hand < std::size_t(kMaxHands); ++hand) {
                QVERIFY(handColours(*theme, hand).finger != handColours(*theme, hand - 1).finger);
                QVERIFY(handColours(*theme, hand).proxy != handColours(*theme, hand - 1).proxy);
            }
        Stage stage;
        TouchOverlay overlay(*stage.solid, *stage.ghost);
        overlay.setTheme(kDarkTheme, 1);
        overlay.setVisible(true);
        overlay.update(touched(), camera(), 0.001);
        COMPARE_SHOWN(stage.props(), "touch-second");
    }

    void theUsualCamera() {
        const ViewCamera c = defaultCamera();
        COMPARE_NEAR(c.fieldOfView, EIGEN_PI / 6, 1e-12, "rad");
        COMPARE_NEAR(c.yaw, EIGEN_PI / 6, 1e-12, "rad");
        COMPARE_NEAR(c.pitch, 22 * EIGEN_PI / 180, 1e-12, "rad");
    }
};

TACTUM_GUI_TEST(TestViewLayers)

} // namespace test_view_layers

#include "test_view_layers.moc"
