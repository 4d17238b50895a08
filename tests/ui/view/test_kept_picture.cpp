// The model's picture is kept while only the touch changes, and never a moment longer: whatever changes, the
// picture is the same to the pixel as one that is drawn as a whole. With TACTUM_TRIANGLES set to a number,
// figures() says how long a picture takes with so many.
#include <ctime>
#include <numeric>

#include <QTest>

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "core/motion/motion_build.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/scene_picker.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_kept_picture {

using namespace tactum;
using namespace tactum::testing;

namespace {

/// On both sides of what is drawn by itself and what is one of a crowd.
constexpr std::array<std::array<Index, 2>, 2> kBalls{{{64, 32}, {32, 16}}};

/// A ball that forces move, and another one beside it; both are painted and have grooves.
Scene sceneOf(Index meridians, Index rings) {
    Scene scene = ballScene(meridians, rings);
    TextureLayer grooves;
    grooves.pattern.source = TextureSource::Grooves;
    grooves.pattern.size = 0.03;
    grooves.strength = 1e-3;
    for (Surface& surface : scene.objects[0].surfaces)
        surface.layers = {grooves};
    SceneObject other = scene.objects[0];
    other.id = 0;
    other.pose.translation = {0.12, 0, 0};
    const Track<Vec3> aside{Interpolation::Linear, {0, 2}, {Vec3::Zero(), {0, 0.05, 0}}, {}, {}};
    other.motion = std::make_shared<const Motion>(makeMotion(aside, {}, 2));
    scene.add(other);
    RigidBody body;
    body.id = 1;
    body.velocity = {0, 0.06, 0};
    scene.objects[0].body = 1;
    scene.mechanics.bodies = {body};
    scene.mechanics.gravity = Vec3::Zero();
    return scene;
}

struct KeptView {
    explicit KeptView(const Scene& shown) : scene(shown) {
        view.resize(330, 250);                  // each picture is compared as a whole: small ones serve
        view.setPictureLimits({.motion = 1e9}); // what is exact does not depend on the machine
        view.setScene(scene);
        setWorld();
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        proxy.updates = servo.ticks = 1;
        touch({0, 0, 0.06});
    }

    void setWorld() {
        world = compile(scene).value();
        view.setWorld(world);
        settle();
    }
    void settle() {
        if (!test::waitFor([&] { return !view.makesFelt(); })) qFatal("it is never made");
    }
    void edit(const std::function<void(Scene&)>& change) {
        change(scene);
        view.setScene(scene);
        settle();
    }
    void felt(const std::function<void(FeltOptions&)>& change) {
        FeltOptions options = view.felt();
        change(options);
        view.setFelt(options);
        settle();
    }
    void touch(const Vec3& at) {
        proxy.output.proxy = at;
        servo.finger = proxy.finger = at - Vec3(0, 0, 0.02);
        proxy.output.force = servo.force = {0, 0, 2};
        proxy.output.contacts = 1;
        proxy.output.contact[0] = {.point = at, .normal = Vec3::UnitZ(), .normalForce = 2};
        proxy.output.contact[0].staticFriction = 0.5;
        haptics();
    }
    void paint(float value) {
        const auto& soup = scene.objects[0].geometry;
        const std::vector<float> values(soup->positions.size(), value);
        view.setPainted(
            {ball(), soup, {{kUpper, std::make_shared<const PaintedValues>(values), nullptr, {}}}});
    }
    void haptics() { view.setHaptics(proxy, servo, 8, true); }

    /// As it is drawn in motion, or at rest: with other samples.
    QImage picture(bool atRest) { return atRest ? view.grabPicture() : view.grabFramebuffer(); }
    ObjectId ball() const { return scene.objects[0].id; }

    Scene scene;
    std::shared_ptr<const World> world;
    SceneView view;
    ProxyTelemetry proxy;
    ServoTelemetry servo;
};

/// Pixels.
int differing(const QImage& a, const QImage& b) {
    if (a == b) return 0;
    if (a.size() != b.size()) return -1;
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

struct Change {
    const char* what;
    std::function<void(KeptView&)> make;
};

const std::vector<Change>& changes() {
    static const std::vector<Change> list{
        {"the finger",
         [](KeptView& v) {
             v.touch({0.03, 0.02, 0.05});
         }},
        {"a finger far away",
         [](KeptView& v) {
             v.touch({0.06, 0, -0.6});
         }},
        {"no touch shown", [](KeptView& v) { v.view.setOverlayVisible(false); }},
        {"the touch again", [](KeptView& v) { v.view.setOverlayVisible(true); }},
        {"the camera's turn", [](KeptView& v) { v.view.moveCamera(0.3, 0.1); }},
        {"the camera's distance", [](KeptView& v) { v.view.moveCamera(0, 0, 0.8); }},
        {"the size", [](KeptView& v) { v.view.resize(280, 270); }},
        {"a colour",
         [](KeptView& v) {
             v.edit([](Scene& s) { s.objects[0].surfaces[kUpper].colour = {0.7f, 0.1f, 0.1f}; });
         }},
        {"a hidden surface",
         [](KeptView& v) { v.edit([](Scene& s) { s.objects[1].surfaces[kUpper].visible = false; }); }},
        {"a hidden object", [](KeptView& v) { v.edit([](Scene& s) { s.objects[1].visible = false; }); }},
        {"a shown object", [](KeptView& v) { v.edit([](Scene& s) { s.objects[1].visible = true; }); }},
        {"a moved object",
         [](KeptView& v) { v.edit([](Scene& s) { s.objects[1].pose.translation.y() += 0.01; }); }},
        {"other triangles",
         [](KeptView& v) { v.edit([](Scene& s) { s.objects[1].geometry = ballSoup(20, 6); }); }},
        {"other surfaces",
         [](KeptView& v) {
             v.edit([](Scene& s) {
                 auto soup = std::make_shared<TriangleSoup>(*s.objects[0].geometry);
                 std::ranges::fill(soup->surfaceOf, kUpper);
                 s.objects[0].geometry = soup;
             });
         }},
        {"a body that moves along keys",
         [](KeptView& v) {
             v.proxy.time = 1;
             v.haptics();
         }},
        {"a body that forces move",
         [](KeptView& v) {
             SimState state;
             v.setWorld();
             for (int i = 0; i < 300; ++i)
                 hapticStep(*v.world, state, {.finger = {0, 1, 0}}, 1e-3);
             v.proxy.bodies = state.bodies;
             v.haptics();
         }},
        {"a surface that is lit",
         [](KeptView& v) {
             const QPointF middle = *v.view.cameraOf(0).project(v.view.placeOf(v.ball())->translation);
             v.view.light(v.view.panes()[0].topLeft() + middle);
         }},
        {"a surface that is lit no more", [](KeptView& v) { v.view.endLight(); }},
        {"a selection",
         [](KeptView& v) {
             v.view.setSelection({{v.ball(), kUpper}});
         }},
        {"the selected body moved",
         [](KeptView& v) {
             v.proxy.bodies = {};
             v.haptics();
         }},
        {"selected triangles",
         [](KeptView& v) {
             v.view.setSelectedFaces(v.ball(), {10, 11, 12, 13, 80});
         }},
        {"other selected triangles",
         [](KeptView& v) {
             v.view.setSelectedFaces(v.ball(), {50, 51, 52});
         }},
        {"what is painted", [](KeptView& v) { v.paint(0.5f); }},
        {"more of it", [](KeptView& v) { v.paint(0.8f); }},
        {"marked triangles",
         [](KeptView& v) {
             v.view.setMarked(v.scene.objects[0].geometry, {20, 21, 22}, Pose());
         }},
        {"the theme", [](KeptView& v) { v.view.setTheme(false); }},
        {"a map", [](KeptView& v) { v.felt([](FeltOptions& o) { o.map = FeltValue::Stiffness; }); }},
        {"a value on the map",
         [](KeptView& v) {
             v.edit([](Scene& s) { s.objects[0].surfaces[kUpper].material.stiffness = 300; });
             v.setWorld();
         }},
        {"a map of layers", [](KeptView& v) { v.felt([](FeltOptions& o) { o.map = FeltValue::Height; }); }},
        {"bumps", [](KeptView& v) { v.felt([](FeltOptions& o) { o.bumps = 10; }); }},
        {"felt normals", [](KeptView& v) { v.felt([](FeltOptions& o) { o.feltNormals = true; }); }},
        {"spheres", [](KeptView& v) { v.felt([](FeltOptions& o) { o.spheres = true; }); }},
        {"another level of them", [](KeptView& v) { v.felt([](FeltOptions& o) { o.sphereLevel = 0; }); }},
        {"none of it", [](KeptView& v) { v.felt([](FeltOptions& o) { o = {}; }); }},
        {"a layer of noise",
         [](KeptView& v) {
             v.edit([](Scene& s) {
                 s.objects[0].surfaces[kUpper].layers[0].pattern.source = TextureSource::Noise;
             });
             v.setWorld();
         }},
        {"a layer of another height",
         [](KeptView& v) {
             v.edit([](Scene& s) { s.objects[0].surfaces[kUpper].layers[0].strength = 3e-3; });
             v.setWorld();
         }},
        {"a layer that is painted",
         [](KeptView& v) {
             v.edit([](Scene& s) {
                 TextureLayer& layer = s.objects[0].surfaces[kUpper].layers[0];
                 layer.pattern.source = TextureSource::Painted;
                 std::vector<float> values(s.objects[0].geometry->positions.size());
                 for (std::size_t i = 0; i < values.size(); i += 3)
                     values[i] = 1;
                 layer.pattern.painted.values = std::make_shared<const PaintedValues>(values);
             });
             v.setWorld();
         }},
        {"no relief", [](KeptView& v) { v.felt([](FeltOptions& o) { o.relief = false; }); }},
        {"the relief again", [](KeptView& v) { v.felt([](FeltOptions& o) { o.relief = true; }); }},
        {"a wireframe", [](KeptView& v) { v.felt([](FeltOptions& o) { o.wireframe = true; }); }},
        {"no wireframe", [](KeptView& v) { v.felt([](FeltOptions& o) { o.wireframe = false; }); }},
        {"a section",
         [](KeptView& v) {
             v.view.setSection(SectionPlane{{Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())), {0, 0, 0.01}}});
             v.settle();
         }},
        {"another place of it",
         [](KeptView& v) {
             v.view.setSection(SectionPlane{{Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())), {0, 0, -0.01}}});
             v.settle();
         }},
        {"no section",
         [](KeptView& v) {
             v.view.setSection(std::nullopt);
             v.settle();
         }},
        {"a parallel projection", [](KeptView& v) { v.view.setParallel(true); }},
        {"no lines between surfaces",
         [](KeptView& v) { v.felt([](FeltOptions& o) { o.boundaries = false; }); }},
        {"no ground", [](KeptView& v) { v.felt([](FeltOptions& o) { o.ground = false; }); }},
        {"the finger before it",
         [](KeptView& v) {
             v.touch({0, 0, 0.055});
         }},
        {"the cone", [](KeptView& v) { v.felt([](FeltOptions& o) { o.cone = true; }); }},
    };
    return list;
}

} // namespace

class TestKeptPicture : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void everyChangeIsSeen_data() {
        QTest::addColumn<int>("ball");
        QTest::addColumn<bool>("atRest");
        QTest::addColumn<ViewSplit>("split");
        // Four panes of a crowd would say nothing that a crowd and four panes do not.
        for (const ViewSplit split : {ViewSplit::One, ViewSplit::Four})
            for (int ball = 0; ball < (split == ViewSplit::One ? int(kBalls.size()) : 1); ++ball)
                for (const bool atRest : {false, true})
                    QTest::addRow("%s, %s%s", ball == 0 ? "alone" : "in a crowd",
                                  atRest ? "at rest" : "in motion",
                                  split == ViewSplit::Four ? ", four panes" : "")
                        << ball << atRest << split;
    }
    void everyChangeIsSeen() {
        QFETCH(int, ball);
        QFETCH(bool, atRest);
        QFETCH(ViewSplit, split);
        const auto [meridians, rings] = kBalls[std::size_t(ball)];
        KeptView shown(sceneOf(meridians, rings));
        shown.view.setSplit(split);
        const int panes = int(shown.view.panes().size());
        QImage before = shown.picture(atRest);
        for (const Change& change : changes()) {
            change.make(shown);
            const QImage kept = shown.picture(atRest);
            QVERIFY2(differing(before, kept) != 0, change.what);
            shown.view.forgetPicture();
            const int drawn = shown.view.modelPictures();
            before = shown.picture(atRest);
            QCOMPARE(shown.view.modelPictures(), drawn + panes);
            const int apart = differing(kept, before);
            QVERIFY2(apart == 0, qPrintable(QStringLiteral("%1: %2 pixels").arg(change.what).arg(apart)));
        }
    }

    // Panes of other shapes as well, one of which looks from below the ground.
    void aTouchDoesNotDrawTheModel_data() {
        QTest::addColumn<ViewSplit>("split");
        QTest::addRow("one") << ViewSplit::One;
        QTest::addRow("columns") << ViewSplit::Columns;
        QTest::addRow("four") << ViewSplit::Four;
    }
    /// Whether it moves or comes to rest.
    void aTouchDoesNotDrawTheModel() {
        QFETCH(ViewSplit, split);
        KeptView shown(sceneOf(64, 32));
        shown.view.setSplit(split);
        shown.view.setDivision({0.4, 0.3});
        if (split != ViewSplit::One) shown.view.moveCamera(0, -1.2);
        const std::array<QImage, 2> first{shown.picture(false), shown.picture(true)};
        const int drawn = shown.view.modelPictures();
        for (int i = 1; i <= 20; ++i) {
            shown.touch(Vec3(0.001 * i, 0.002 * i, 0.058 + 0.0005 * i)); // nearer to the eye
            for (const bool atRest : {false, true})
                QCOMPARE_GT(differing(shown.picture(atRest), first[atRest]), 50);
        }
        QCOMPARE(shown.view.modelPictures(), drawn);
        for (const bool atRest : {false, true}) {
            const QImage kept = shown.picture(atRest);
            shown.view.forgetPicture();
            QCOMPARE(differing(kept, shown.picture(atRest)), 0);
        }
    }

    // The finger behind the ball is hidden by it, but for its dimmed copy.
    void theKeptModelHidesWhatIsBehindIt() {
        KeptView shown(sceneOf(64, 32));
        shown.view.showStandardView(StandardView::Front);
        shown.touch({0, 0, 0.06});
        const QPoint centre = shown.view.camera().project(Vec3(0, 0, 0.04))->toPoint();
        const auto finger = [&](double z) {
            shown.touch({0, 0, z + 0.02});
            return shown.view.grabFramebuffer().pixelColor(centre * shown.view.devicePixelRatioF());
        };
        (void)finger(0.06);
        const QColor before = finger(0.08), behind = finger(-0.1);
        QCOMPARE_GT(std::abs(before.blue() - behind.blue()) + std::abs(before.red() - behind.red()), 60);
    }

    void figures();

private:
    static void restFigures(KeptView& shown);
};

/// What one event costs at most while the camera turns, and until the picture rests; processor time, with all
/// that Qt does.
void TestKeptPicture::restFigures(KeptView& shown) {
    const auto longest = [&](auto until) {
        double most = 0;
        while (!until()) {
            const std::clock_t before = std::clock();
            QCoreApplication::processEvents();
            most = std::max(most, 1e3 * double(std::clock() - before) / CLOCKS_PER_SEC);
        }
        return most;
    };
    for (int i = 0; i < 5; ++i) {
        double turning = 0;
        for (int k = 0; k < 5; ++k) {
            shown.view.moveCamera(0.05, 0);
            turning = std::max(turning, longest([&, drawn = shown.view.modelPictures()] {
                                   return shown.view.modelPictures() > drawn;
                               }));
        }
        const double resting = longest([&] { return shown.view.rests(); });
        qInfo("shown: turning at most %6.1f ms, until it rests %6.1f ms", turning, resting);
    }
}

/// Processor time of pictures of 1280 x 800, read back: as software draws what moves, without samples, and at
/// rest.
void TestKeptPicture::figures() {
    const int triangles = qEnvironmentVariableIntValue("TACTUM_TRIANGLES");
    if (triangles < 8) QSKIP("TACTUM_TRIANGLES says of how many");
    const auto rings = Index(std::sqrt(triangles / 4.0));
    KeptView shown(ballScene(2 * rings, rings));
    shown.view.resize(1280, 800);
    shown.view.setPictureLimits({});
    if (!test::waitFor([&] { return !shown.view.makesMeshes(); })) qFatal("the meshes are never made");
    const auto measure = [&](const char* what, bool atRest, int count, auto change) {
        std::vector<double> ms;
        for (int i = 0; i < count; ++i) {
            change(i);
            const std::clock_t before = std::clock();
            (void)shown.picture(atRest);
            ms.push_back(1e3 * double(std::clock() - before) / CLOCKS_PER_SEC);
        }
        std::ranges::sort(ms);
        qInfo("%-10s %-9s least %7.1f median %7.1f ms", what, atRest ? "at rest" : "in motion", ms.front(),
              ms[ms.size() / 2]);
    };
    std::vector<Index> all(shown.scene.objects[0].geometry->triangles.size());
    std::iota(all.begin(), all.end(), Index(0));
    const auto select = [&](int i) {
        shown.view.setSelectedFaces(shown.ball(),
                                    i % 2 ? all : std::vector<Index>(all.begin() + 1, all.end()));
    };
    const auto touch = [&](int i) { shown.touch({0.001 * (i % 40), 0.001 * (i % 30), 0.055}); };
    for (const bool atRest : {false, true}) {
        const int count = atRest ? 7 : 21;
        measure("all drawn", atRest, count, [&](int i) {
            touch(i);
            shown.view.forgetPicture();
        });
        measure("kept", atRest, count, touch);
        measure("selecting", atRest, 5, select);
        measure("selected", atRest, count, touch);
        shown.view.setSelectedFaces(0, {});
        measure("orbit", atRest, count, [&](int) { shown.view.moveCamera(0.05, 0); });
        for (const ViewSplit split : {ViewSplit::Columns, ViewSplit::Four}) {
            shown.view.setSplit(split);
            qInfo("%s:", split == ViewSplit::Columns ? "two panes" : "four panes");
            measure("kept", atRest, count, touch);
            measure("orbit", atRest, count, [&](int) { shown.view.moveCamera(0.05, 0); });
            measure("all drawn", atRest, count, [&](int i) {
                touch(i);
                shown.view.forgetPicture();
            });
        }
        shown.view.setSplit(ViewSplit::One);
    }
    SectionPlane cut; // through the middle
    for (const bool atRest : {false, true}) {
        const int count = atRest ? 7 : 21;
        shown.view.setSection(cut);
        measure("cut, orbit", atRest, count, [&](int) { shown.view.moveCamera(0.05, 0); });
        measure("cut, drag", atRest, count, [&](int i) {
            cut.frame.translation.z() = 0.001 * (i % 20);
            shown.view.setSection(cut);
        });
        shown.view.setSection({});
    }
    restFigures(shown);
    for (const TextureSource source : {TextureSource::Grooves, TextureSource::Noise})
        for (const TextureMapping mapping : {TextureMapping::Planar, TextureMapping::Triplanar}) {
            for (Surface& surface : shown.scene.objects[0].surfaces) {
                surface.layers.assign(1, {});
                surface.layers[0].pattern.source = source;
                surface.layers[0].pattern.mapping = mapping;
            }
            shown.setWorld();
            qInfo("a relief of %s, %s:", kTextureSources[std::size_t(source)].label.data(),
                  kTextureMappings[std::size_t(mapping)].label.data());
            measure("orbit", false, 21, [&](int) { shown.view.moveCamera(0.05, 0); });
        }
}

TACTUM_GUI_TEST(TestKeptPicture)

} // namespace test_kept_picture

#include "test_kept_picture.moc"
