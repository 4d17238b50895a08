// What the view hands to the renderers and paints over them, before any picture is drawn: of each state the
// lines that the one before had not. Wrong itself if something that is seen were no actor and not painted
// over: the outline's width, what is kept of a picture, light and shaders are for tests of pixels.
#include <QTest>

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "core/motion/motion_build.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/view/ball_scene.h"
#include "tests/ui/view/held_view.h"
#include "ui/view/surface_format.h"

namespace test_view_holds {

using namespace tactum;
using namespace tactum::testing;

namespace {

constexpr QSize kSize(640, 480);
const Vec3 kProxy(-0.02, 0, 0.056); ///< before the ball, a little to the left

TextureLayer layerFrom(TextureSource source, double strength) {
    TextureLayer layer;
    layer.pattern.source = source;
    layer.pattern.mapping = TextureMapping::Planar;
    layer.pattern.size = 0.03;
    layer.strength = strength;
    return layer;
}

/// A ball of many triangles; one of few, which moves along keys; a plate with texture coordinates.
Scene threeBodies() {
    Scene scene = ballScene(46, 24);
    SceneObject& ball = scene.objects[0];
    ball.surfaces[kLower].material = {200, 1, 0.3, 0.2, 1};
    ball.surfaces[kUpper].material = {1000, 2, 0.8, 0.6, 0.5};
    ball.surfaces[kUpper].layers = {layerFrom(TextureSource::Grooves, 1e-3)};
    SceneObject small = ballScene(12, 6).objects[0];
    small.id = 0;
    small.name = "small";
    small.pose.translation = {0.12, 0, 0};
    const Track<Vec3> up{Interpolation::Linear, {0, 2}, {Vec3::Zero(), {0, 0.05, 0}}, {}, {}};
    small.motion = std::make_shared<const Motion>(makeMotion(up, {}, 2));
    scene.add(small);
    SceneObject plate = knownScene().objects[1];
    plate.id = 0;
    plate.pose.translation = {-0.15, 0, 0};
    scene.add(plate);
    return scene;
}

HapticOutput touchOf(bool slips) {
    HapticOutput touch;
    touch.proxy = kProxy;
    touch.force = {4, 1, 0};
    touch.contacts = 1;
    touch.contact[0] = {.point = kProxy, .normal = Vec3::UnitX(), .normalForce = 4, .slipping = slips};
    touch.contact[0].staticFriction = 0.5;
    touch.contact[0].dynamicFriction = 0.25;
    return touch;
}

TracePoint placeAt(double t, const Vec3& proxy) {
    TracePoint point;
    point.t = t;
    point.proxy = proxy;
    point.touching = true;
    return point;
}

/// A view of a scene from the front, and what differs from state to state.
class Held {
public:
    explicit Held(const Scene& first) : scene(first) {
        QApplication::setFont(QFont(QStringLiteral("DejaVu Sans"), 10));
        view.setScene(scene);
        publish();
        view.showStandardView(StandardView::Front);
        CameraManners manners;
        manners.flies = false;
        view.setManners(manners);
        proxy.updates = servo.ticks = 1;
    }
    void note(
        const QString& words, const std::function<void()>& act = [] {}) {
        act();
        QApplication::processEvents();
        if (!test::waitFor([&] { return !view.makesFelt() && !view.makesMeshes(); }))
            qFatal("it never rests");
        const QStringList now = view.holds().split(u'\n');
        text_ += words + QStringLiteral(":\n");
        for (const QString& line : changedLines(before_, now).split(u'\n', Qt::SkipEmptyParts))
            text_ +=
                (line.startsWith(QStringLiteral("  - ")) ? line.left(60) : line) + u'\n'; // known already
        before_ = now;
    }
    void edit(const QString& words, const std::function<void(Scene&)>& change) {
        note(words, [&] {
            change(scene);
            view.setScene(scene);
            publish();
        });
    }
    void felt(const QString& words, const std::function<void(FeltOptions&)>& change) {
        note(words, [&] {
            FeltOptions options = view.felt();
            change(options);
            view.setFelt(options);
        });
    }
    void publish() {
        world = compile(scene, world.get()).value();
        view.setWorld(world);
    }
    void touch(const HapticOutput& output, const Vec3& finger) {
        proxy.output = output;
        proxy.finger = servo.finger = finger;
        servo.force = output.force;
        view.setHaptics(proxy, servo, 8, armed);
    }
    void touch(bool slips = false) { touch(touchOf(slips), kProxy - Vec3(0.005, 0, 0)); }
    QPoint pixelOf(const Vec3& p_W) const { return view.camera().project(p_W)->toPoint(); }
    void mouse(QEvent::Type what, QPoint at, Qt::MouseButton button = Qt::LeftButton,
               Qt::KeyboardModifiers keys = {}) {
        testing::mouse(view, what, at, button, keys);
    }
    /// Over the view, without a button.
    void point(QPoint at) { move(at, Qt::NoButton); }
    void move(QPoint to, Qt::MouseButton button, Qt::KeyboardModifiers keys = {}) {
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(QPointF(to)), Qt::NoButton, button, keys);
        QApplication::sendEvent(&view, &event);
    }
    void wheel(QPoint at, int notches) {
        QWheelEvent event(at, view.mapToGlobal(QPointF(at)), {}, {0, 120 * notches}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
    }
    const QString& text() const { return text_; }

    Scene scene;
    HeldView view{kSize};
    std::shared_ptr<const World> world;
    ProxyTelemetry proxy;
    ServoTelemetry servo;
    bool armed = true;

private:
    QStringList before_;
    QString text_;
};

} // namespace

class TestViewHolds : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void theTouch();
    void theCamera();
    void panes();
    void theScene();
    void whatMoves();
    void howItFeels();
    void whatIsPainted();
    void handles();
    void tools();
};

void TestViewHolds::theTouch() {
    Held held(ballScene(16, 8));
    SceneView& view = held.view;
    held.note("nothing touches");
    held.note("it sticks", [&] { held.touch(); });
    held.note("its name", [&] { view.setTouched("lower"); });
    held.note("it slips", [&] { held.touch(true); });
    held.felt("the cone", [](FeltOptions& o) { o.cone = true; });
    held.note("it sticks", [&] { held.touch(); });
    held.felt("no normals", [](FeltOptions& o) { o.normals = false; });
    held.felt("no planes", [](FeltOptions& o) { o.planes = false; });
    held.felt("the stylus", [](FeltOptions& o) { o.stylus = true; });
    held.felt("none of it", [](FeltOptions& o) { o = {}; });
    held.note("without force", [&] {
        held.armed = false;
        held.touch();
    });
    held.note("twice as large", [&] { view.setTouchScale(2); });
    held.note("a larger proxy", [&] { view.setProxyRadius(0.004); });
    held.note("as it was", [&] {
        view.setTouchScale(1);
        view.setProxyRadius(0.001);
        held.armed = true;
        held.touch();
    });
    held.note("another one beside", [&] {
        HandBeside other;
        other.mark = {1, "Other", false};
        other.touch.output = touchOf(true);
        other.touch.output.proxy = other.servo.finger = {0.06, 0.01, 0};
        other.touch.finger = other.servo.finger;
        other.servo.force = {0, 2, 0};
        other.servo.ticks = 1;
        other.forceLimit = 4;
        other.armed = true;
        view.setHands({0, "First", true}, {other});
        held.touch();
    });
    held.note("the other one's words", [&] { view.setHands({1, "Second", false}, {}); });
    held.note("alone", [&] { view.setHands({}, {}); });
    held.note("hidden", [&] { view.setOverlayVisible(false); });
    held.note("seen", [&] { view.setOverlayVisible(true); });
    held.felt("a trail", [](FeltOptions& o) { o.trail = true; });
    held.note("it slides and rests", [&] {
        std::vector<TracePoint> slide, rest;
        for (int i = 0; i <= 200; ++i)
            slide.push_back(placeAt(1e-3 * i, kProxy + Vec3(2e-4 * i, 0, 0)));
        for (int i = 1; i <= 300; ++i)
            rest.push_back(placeAt(0.2 + 1e-3 * i, kProxy + Vec3(0.04, 0, 0)));
        view.addTrail(slide, touchOf(true));
        view.addTrail(rest, touchOf(false));
    });
    held.note("the trail is cleared", [&] { view.clearTrail(); });
    held.note("far away", [&] {
        HapticOutput far = touchOf(false);
        far.proxy = {0.3, 0.2, 0};
        held.touch(far, {0.31, 0.2, 0});
    });
    held.note("behind", [&] {
        HapticOutput behind = touchOf(false);
        behind.proxy = {0, 0, 2};
        held.touch(behind, {0, 0, 2.01});
    });
    held.note("nothing is touched", [&] {
        HapticOutput none;
        none.proxy = {0.08, 0, 0};
        held.touch(none, none.proxy);
    });
    held.note("the light theme", [&] { view.setTheme(false); });
    COMPARE_SHOWN(held.text(), "holds-touch");
}

void TestViewHolds::theCamera() {
    Held held(ballScene(16, 8));
    SceneView& view = held.view;
    held.note("from the front");
    for (const auto& [name, standard] : {std::pair("from the right", StandardView::Right),
                                         {"from above", StandardView::Top},
                                         {"from the corner", StandardView::Isometric}})
        held.note(name, [&] { view.showStandardView(standard); });
    held.note("turned", [&] { view.moveCamera(0.3, -0.2); });
    held.note("nearer", [&] { view.moveCamera(0, 0, 0.5); });
    held.note("as near as can be", [&] { view.moveCamera(0, 0, 1e-9); });
    held.note("as far as can be", [&] { view.moveCamera(0, 0, 1e9); });
    held.note("all of it", [&] { view.fit(); });
    held.note("from below", [&] { view.moveCamera(0, -1.2); });
    held.note("parallel", [&] { view.setParallel(true); });
    held.note("from the side", [&] { view.showStandardView(StandardView::Front); });
    held.note("from a little above", [&] { view.moveCamera(0, 2e-3); });
    held.note("with vanishing points", [&] { view.setParallel(false); });
    held.note("to a place", [&] { view.flyTo({0.02, 0.03, 0}, 0.01); });
    held.note("to a place from the left", [&] { view.flyTo({0, 0, 0}, 0.03, {-1, 1, 0}); });
    held.note("to a place that is small", [&] { view.flyTo({0, 0, 0}, 0); });
    held.note("home", [&] { view.planViews(); });
    held.note("nearer at a place", [&] { held.wheel(held.pixelOf({0, 0.04, 0.03}), 2); });
    held.note("nearer beside", [&] { held.wheel({40, 40}, 1); });
    held.note("farther in the middle", [&] {
        CameraManners manners;
        manners.flies = manners.zoomToCursor = false;
        manners.zoomSpeed = 2;
        view.setManners(manners);
        held.wheel({40, 40}, -1);
    });
    held.note("the wide view", [&] { view.resize(300, 480); });
    held.felt("a map", [](FeltOptions& o) { o.map = FeltValue::Stiffness; });
    held.note("a foot", [&] { view.setFoot(60); });
    held.note("without a ground", [&] {
        FeltOptions options;
        options.ground = false;
        view.setFelt(options);
    });
    held.note("covered", [&] { view.setCovered(QRegion(200, 0, 100, 60)); });
    COMPARE_SHOWN(held.text(), "holds-camera");
}

void TestViewHolds::panes() {
    Held held(ballScene(16, 8));
    SceneView& view = held.view;
    held.note("whole");
    held.note("columns", [&] { view.setSplit(ViewSplit::Columns); });
    held.note("rows", [&] { view.setSplit(ViewSplit::Rows); });
    held.note("four", [&] { view.setSplit(ViewSplit::Four); });
    held.note("divided elsewhere", [&] { view.setDivision({0.3, 0.6}); });
    held.note("divided at the edge", [&] { view.setDivision({0, 1}); });
    held.note("another one is active", [&] {
        view.setDivision({0.5, 0.5});
        held.point({500, 400});
    });
    held.note("it is turned", [&] { view.moveCamera(0.3, 0.2); });
    held.note("it is another projection", [&] { view.setParallel(false); });
    held.note("the line is led", [&] {
        held.mouse(QEvent::MouseButtonPress, {320, 100});
        held.move({400, 120}, Qt::LeftButton);
        held.mouse(QEvent::MouseButtonRelease, {400, 120});
    });
    held.note("the line is in the middle", [&] { held.mouse(QEvent::MouseButtonDblClick, {400, 100}); });
    held.note("touched", [&] { held.touch(); });
    held.felt("a map", [](FeltOptions& o) { o.map = FeltValue::Stiffness; });
    held.note("a section", [&] { view.setSection(SectionPlane{}); });
    held.note("whole", [&] { view.setSplit(ViewSplit::One); });
    COMPARE_SHOWN(held.text(), "holds-panes");
}

void TestViewHolds::theScene() {
    Held held(threeBodies());
    SceneView& view = held.view;
    held.note("as it is");
    held.edit("a colour", [](Scene& s) { s.objects[0].surfaces[kUpper].colour = {0.7f, 0.1f, 0.2f}; });
    held.edit("a colour of the small one", [](Scene& s) {
        s.objects[1].surfaces[kUpper].colour = {0.7f, 0.1f, 0.2f};
    });
    held.note("looks alone", [&] {
        held.scene.objects[0].surfaces[kLower].colour = {0.1f, 0.6f, 0.2f};
        held.scene.objects[1].surfaces[kLower].material.staticFriction = 0.05;
        view.setLooks(held.scene);
    });
    held.edit("a hidden surface", [](Scene& s) { s.objects[0].surfaces[kLower].visible = false; });
    held.edit("a hidden surface of the small one",
              [](Scene& s) { s.objects[1].surfaces[kLower].visible = false; });
    held.edit("a hidden object", [](Scene& s) { s.objects[2].visible = false; });
    held.edit("all are seen", [](Scene& s) {
        s.objects[2].visible = true;
        for (int i : {0, 1})
            s.objects[std::size_t(i)].surfaces[kLower].visible = true;
    });
    held.edit("moved", [](Scene& s) {
        s.objects[0].pose = {Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY())), {0, 0.02, 0}};
        s.objects[1].pose.translation.z() += 0.03;
    });
    held.edit("another shape", [](Scene& s) { s.objects[1].geometry = ballSoup(16, 8); });
    held.edit("other surfaces", [](Scene& s) {
        auto soup = std::make_shared<TriangleSoup>(*s.objects[0].geometry);
        for (std::size_t i = 0; i < soup->surfaceOf.size() / 4; ++i)
            soup->surfaceOf[i] = kLower;
        s.objects[0].geometry = soup;
    });
    held.edit("one surface more", [](Scene& s) {
        auto soup = std::make_shared<TriangleSoup>(*s.objects[0].geometry);
        for (std::size_t i = 0; i < 40; ++i)
            soup->surfaceOf[i] = 2;
        s.objects[0].geometry = soup;
        s.objects[0].surfaces.push_back(s.objects[0].surfaces[0]);
    });
    held.edit("one object less", [](Scene& s) { s.objects.pop_back(); });
    const ObjectId ball = held.scene.objects[0].id, small = held.scene.objects[1].id;
    held.note("selected", [&] { view.setSelection({{ball, kUpper}}); });
    held.note("two of them", [&] { view.setSelection({{ball, kUpper}, {small, kLower}, {small, kUpper}}); });
    held.note("triangles", [&] { view.setSelectedFaces(ball, {10, 11, 12, 13, 80}); });
    held.note("brushed", [&] { view.setBrushedFaces(small, {1, 2, 3}); });
    held.note("none", [&] {
        view.setSelection({});
        view.setSelectedFaces(0, {});
        view.setBrushedFaces(0, {});
    });
    held.note("marked", [&] {
        view.setMarked(held.scene.objects[1].geometry, {2, 3, 4}, held.scene.objects[1].pose);
    });
    held.note("marked no more", [&] { view.setMarked(nullptr, {}, Pose()); });
    for (const auto& [name, at] :
         {std::pair("under the pointer", Vec3(0, 0.05, 0.03)), {"the small one", Vec3(0.12, -0.02, 0.06)}})
        held.note(name, [&, p = at] { view.light(held.pixelOf(p)); });
    held.note("nothing under it", [&] { view.endLight(); });
    SectionPlane plane;
    plane.frame.translation = {0.01, 0.02, 0};
    plane.frame.rotation = Quat(Eigen::AngleAxisd(0.5, Vec3(1, 1, 0).normalized()));
    held.note("cut", [&] { view.setSection(plane); });
    held.note("whole", [&] { view.setSection(std::nullopt); });
    held.felt("no ground", [](FeltOptions& o) { o.ground = false; });
    held.felt("no lines between surfaces", [](FeltOptions& o) { o.boundaries = false; });
    held.felt("wires", [](FeltOptions& o) {
        o = {};
        o.wireframe = true;
    });
    held.felt("as it was", [](FeltOptions& o) { o = {}; });
    held.note("the light theme", [&] { view.setTheme(false); });
    held.edit("nothing is left", [](Scene& s) { s.objects.clear(); });
    COMPARE_SHOWN(held.text(), "holds-scene");
}

// Without a ground: when its shadow comes, 0.3 s after the last movement, is up to the clock.
void TestViewHolds::whatMoves() {
    Scene scene = threeBodies();
    RigidBody body;
    body.id = 1;
    body.velocity = {0, 0.06, 0};
    scene.objects[0].body = 1;
    scene.mechanics.bodies = {body};
    scene.mechanics.gravity = Vec3::Zero();
    Held held(scene);
    SceneView& view = held.view;
    held.felt("without a ground", [](FeltOptions& o) { o.ground = false; });
    held.note("selected", [&] {
        view.setSelection({{held.scene.objects[0].id, kUpper}, {held.scene.objects[1].id, kUpper}});
        view.setSelectedFaces(held.scene.objects[0].id, {10, 11});
    });
    held.note("along keys", [&] {
        held.proxy.time = 1;
        held.touch();
    });
    held.note("the time of the others", [&] {
        held.proxy.time = 0;
        held.touch();
    });
    SimState state;
    for (int i = 0; i < 300; ++i)
        hapticStep(*held.world, state, {.finger = {0, 1, 0}}, 1e-3);
    held.note("by forces", [&] {
        held.proxy.bodies = state.bodies;
        held.touch();
    });
    held.note("far away", [&] {
        for (int i = 0; i < state.bodies.qs; ++i)
            held.proxy.bodies.q[std::size_t(i)] = i == 1 ? -50.0 : state.bodies.q[std::size_t(i)];
        held.touch();
    });
    held.note("where they begin", [&] {
        held.proxy.bodies = {};
        held.touch();
    });
    held.felt("spheres", [](FeltOptions& o) { o.spheres = true; });
    held.note("by forces", [&] {
        held.proxy.bodies = state.bodies;
        held.touch();
    });
    held.edit("it is still now", [](Scene& s) {
        s.objects[0].body = kWorldBody;
        s.mechanics.bodies.clear();
    });
    COMPARE_SHOWN(held.text(), "holds-moving");
}

void TestViewHolds::howItFeels() {
    Held held(threeBodies());
    held.note("as it is");
    for (const auto& [name, value] : {std::pair("stiffness", FeltValue::Stiffness),
                                      {"damping", FeltValue::Damping},
                                      {"static friction", FeltValue::StaticFriction},
                                      {"dynamic friction", FeltValue::DynamicFriction},
                                      {"viscosity", FeltValue::Viscosity},
                                      {"height", FeltValue::Height}})
        held.felt(name, [v = value](FeltOptions& o) { o.map = v; });
    held.felt("bumps", [](FeltOptions& o) {
        o = {};
        o.bumps = 5;
    });
    held.felt("no relief", [](FeltOptions& o) {
        o = {};
        o.relief = false;
    });
    held.felt("normals", [](FeltOptions& o) {
        o = {};
        o.feltNormals = true;
    });
    held.felt("spheres", [](FeltOptions& o) {
        o = {};
        o.spheres = true;
    });
    held.felt("the coarsest", [](FeltOptions& o) { o.sphereLevel = 0; });
    held.felt("the finest", [](FeltOptions& o) { o.sphereLevel = kDeepestLevel; });
    held.felt("none of it", [](FeltOptions& o) { o = {}; });
    const auto layers = [&](const char* words, std::vector<TextureLayer> list) {
        held.edit(words, [&](Scene& s) {
            s.objects[1].surfaces[kUpper].layers = list;
            s.objects[2].surfaces[0].layers = list;
        });
    };
    TextureLayer noise = layerFrom(TextureSource::Noise, 2e-3), bumps = layerFrom(TextureSource::Dots, 1e-3);
    noise.pattern.mapping = TextureMapping::Triplanar;
    noise.pattern.rotation = 0.3;
    bumps.pattern.mapping = TextureMapping::Spherical;
    bumps.pattern.radius = 0.04;
    bumps.opacity = 0.5;
    bumps.mask = layerFrom(TextureSource::Weave, 1).pattern;
    layers("noise", {noise});
    layers("bumps over it", {noise, bumps});
    for (const auto blend : {TextureBlend::Subtract, TextureBlend::Multiply, TextureBlend::Maximum,
                             TextureBlend::Minimum, TextureBlend::Replace}) {
        bumps.blend = blend;
        layers(qPrintable(QStringLiteral("blend %1").arg(int(blend))), {noise, bumps});
    }
    TextureLayer friction = layerFrom(TextureSource::Grooves, 0.4);
    friction.target = TextureTarget::StaticFriction;
    layers("friction alone", {friction});
    held.felt("as colours", [](FeltOptions& o) { o.map = FeltValue::StaticFriction; });
    TextureLayer uv = layerFrom(TextureSource::Image, 1e-3);
    uv.pattern.mapping = TextureMapping::Uv;
    std::vector<std::uint16_t> texels(16 * 8);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = std::uint16_t(i * 509);
    uv.pattern.image = std::make_shared<const TextureImage>(16, 8, texels);
    held.edit("an image", [&](Scene& s) { s.objects[2].surfaces[0].layers = {uv}; });
    held.felt("in relief", [](FeltOptions& o) { o = {}; });
    TextureLayer painted = layerFrom(TextureSource::Painted, 1e-3);
    painted.pattern.painted.values =
        std::make_shared<const PaintedValues>(std::vector<float>{0.f, 0.5f, 1.f, 0.25f});
    held.edit("painted", [&](Scene& s) { s.objects[2].surfaces[0].layers = {painted, uv}; });
    COMPARE_SHOWN(held.text(), "holds-felt");
}

void TestViewHolds::whatIsPainted() {
    Held held(threeBodies());
    SceneView& view = held.view;
    held.note("nothing is");
    const SceneObject &ball = held.scene.objects[0], &plate = held.scene.objects[2];
    std::vector<float> values(ball.geometry->positions.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = float(i % 11) / 10;
    const auto corners = std::make_shared<const PaintedValues>(values);
    held.note("at corners", [&] {
        view.setPainted({ball.id, ball.geometry, {{kUpper, corners, nullptr, {}}}});
    });
    held.note("on both", [&] {
        view.setPainted(
            {ball.id, ball.geometry, {{kUpper, corners, nullptr, {}}, {kLower, nullptr, nullptr, {}}}});
    });
    held.felt("as high as it is felt", [](FeltOptions& o) { o.bumps = 5; });
    held.felt("flat", [](FeltOptions& o) { o.bumps = 0; });
    std::vector<std::uint16_t> texels(32 * 16);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = std::uint16_t(i * 127);
    const auto image = std::make_shared<const TextureImage>(32, 16, texels);
    TexelMap map{32, 16, Eigen::Vector2d(32, 16).asDiagonal(), {1, 2}};
    held.note("by texels", [&] { view.setPainted({plate.id, plate.geometry, {{0, nullptr, image, map}}}); });
    held.edit("on an object that is hidden", [](Scene& s) { s.objects[2].visible = false; });
    held.note("nothing is", [&] { view.setPainted({}); });
    COMPARE_SHOWN(held.text(), "holds-paint");
}

void TestViewHolds::handles() {
    Held held(ballScene(16, 8));
    SceneView& view = held.view;
    held.note("none");
    view.setTool(ViewTool::Arrange);
    held.note("arranging", [&] { view.setArranging(Pose{Quat::Identity(), {0.01, 0, 0}}); });
    const QPoint tip = held.pixelOf({0.01, 0, 0}) + QPoint(30, 0);
    held.note("under the pointer", [&] { held.point(tip); });
    held.note("led", [&] {
        held.mouse(QEvent::MouseButtonPress, tip);
        held.move(tip + QPoint(20, 10), Qt::LeftButton);
    });
    held.note("let go", [&] { held.mouse(QEvent::MouseButtonRelease, tip + QPoint(20, 10)); });
    view.setArranging(std::nullopt);
    held.note("a mapping", [&] {
        MappingFrame frame;
        frame.mapping = TextureMapping::Planar;
        frame.size = 0.04;
        view.setMapping(frame);
    });
    view.setMapping(std::nullopt);
    held.note("a joint", [&] {
        view.setJoint(JointMark{true, {-0.02, 0, 0}, Vec3::UnitY(), {0.04, 0.01, 0}, -0.6, 1.2, true, true});
    });
    view.setJoint(std::nullopt);
    held.note("a path", [&] {
        view.setPath(
            PathMark{{{-0.05, 0, 0}, {0, 0.03, 0}, {0.05, 0, 0}},
                     false,
                     {{-0.05, 0, 0}, {-0.02, 0.02, 0}, {0, 0.03, 0}, {0.03, 0.02, 0}, {0.05, 0, 0}}});
    });
    view.setPath(std::nullopt);
    held.note("a section", [&] {
        SectionPlane plane;
        plane.frame.rotation = Quat(Eigen::AngleAxisd(0.5, Vec3(1, 1, 0).normalized()));
        view.setSection(plane);
    });
    view.setSection(std::nullopt);
    held.note("a mass", [&] { view.setMass(MassMark{Pose{}, {0.01, 0.02, 0.03}}); });
    held.note("colliders", [&] {
        view.setMass(std::nullopt);
        view.setColliders({{held.scene.objects[0].id, {{{0, 0, 0}, {0.03, 0, 0}, {0.03, 0.03, 0}}}},
                           {0, {{{-0.05, 0, 0}, {-0.05, 0.05, 0}}}}});
    });
    held.edit("of an object that is hidden", [](Scene& s) { s.objects[0].visible = false; });
    COMPARE_SHOWN(held.text(), "holds-handles");
}

void TestViewHolds::tools() {
    Held held(ballScene(16, 8));
    SceneView& view = held.view;
    held.note("touch");
    const QPoint upper = held.pixelOf({0, 0.03, 0.04}), lower = held.pixelOf({0, -0.03, 0.04}),
                 beside(60, 40);
    held.note("over the model", [&] { held.point(upper); });
    held.note("beside it", [&] { held.point(beside); });
    view.setTool(ViewTool::Measure);
    held.note("measure", [&] { held.point(upper); });
    for (const auto& [name, at] : {std::pair("one point", upper),
                                   {"two points", lower},
                                   {"three points", (upper + lower) / 2 + QPoint(60, 0)},
                                   {"anew", lower}})
        held.note(name, [&, p = at] {
            held.mouse(QEvent::MouseButtonPress, p);
            held.mouse(QEvent::MouseButtonRelease, p);
        });
    held.note("cleared", [&] { view.clearMeasure(); });
    view.setTool(ViewTool::Paint);
    held.note("paint", [&] {
        view.setBrush({0.01, 0.4});
        held.point(upper);
    });
    held.note("a stroke", [&] {
        held.mouse(QEvent::MouseButtonPress, upper);
        held.move(lower, Qt::LeftButton);
    });
    held.note("it leaves", [&] {
        held.move(beside, Qt::LeftButton);
        held.mouse(QEvent::MouseButtonRelease, beside);
    });
    view.setTool(ViewTool::Select);
    held.note("the brush", [&] {
        view.setSelectBrush(20);
        held.point(upper);
    });
    held.note("it goes on", [&] {
        held.mouse(QEvent::MouseButtonPress, upper);
        held.move(lower, Qt::LeftButton);
    });
    held.note("no brush", [&] {
        held.mouse(QEvent::MouseButtonRelease, lower);
        view.setSelectBrush(std::nullopt);
    });
    for (const auto& [name, shape] : {std::pair("a box", RegionShape::Box), {"a line", RegionShape::Lasso}}) {
        held.note(name, [&, s = shape] {
            view.beginRegion(s);
            held.mouse(QEvent::MouseButtonPress, beside);
            held.move(upper, Qt::LeftButton);
            held.move(lower, Qt::LeftButton);
        });
        held.note("it is closed", [&] { held.mouse(QEvent::MouseButtonRelease, lower); });
    }
    const QPoint axis(586 + 31, 54);
    held.note("an axis", [&] { held.point(axis); });
    held.note("from its end", [&] {
        held.mouse(QEvent::MouseButtonPress, axis);
        held.mouse(QEvent::MouseButtonRelease, axis);
    });
    held.note("turned by the mouse", [&] {
        held.mouse(QEvent::MouseButtonPress, beside);
        held.move(beside + QPoint(48, 24), Qt::LeftButton);
        held.mouse(QEvent::MouseButtonRelease, beside + QPoint(48, 24));
    });
    held.note("moved by the mouse", [&] {
        held.mouse(QEvent::MouseButtonPress, upper, Qt::MiddleButton, Qt::ShiftModifier);
        held.move(upper + QPoint(30, 20), Qt::MiddleButton, Qt::ShiftModifier);
        held.mouse(QEvent::MouseButtonRelease, upper + QPoint(30, 20), Qt::MiddleButton, Qt::ShiftModifier);
    });
    held.note("the pointer leaves", [&] {
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&view, &leave);
    });
    COMPARE_SHOWN(held.text(), "holds-tools");
}

TACTUM_GUI_TEST(TestViewHolds)

} // namespace test_view_holds

#include "test_view_holds.moc"
