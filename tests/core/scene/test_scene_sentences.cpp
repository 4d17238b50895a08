// Every sentence that is said of a scene, with its numbers, its remedy and how bad it is.
#include <cmath>
#include <limits>

#include <QTest>

#include "core/motion/body_motion.h"
#include "core/motion/motion_build.h"
#include "core/scene/findings.h"
#include "core/scene/value_checks.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_sentences {

using namespace tactum;

namespace {

using Severity = Finding::Severity;

std::shared_ptr<TriangleSoup> tetrahedron(double size = 0.1) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    soup->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    soup->surfaceOf = {0, 0, 0, 0};
    return soup;
}

Scene soundScene() {
    Scene scene;
    SceneObject object;
    object.name = "rock";
    object.geometry = tetrahedron();
    object.surfaces.resize(1);
    object.surfaces[0].name = "side";
    scene.add(object);
    return scene;
}

std::string text(const Finding& finding) {
    const char* words[] = {"note", "warning", "error"};
    return std::string(words[int(finding.severity)]) + "|" + finding.object + "|" + finding.sentence + "|" +
           finding.remedy;
}

QStringList said(const Scene& scene) {
    QStringList lines;
    for (const Finding& finding : validate(scene))
        lines << QString::fromStdString(text(finding));
    return lines;
}

/// What is said of the scene after a change; nothing is said of it before.
template <class Change> QStringList after(Change change) {
    Scene scene = soundScene();
    change(scene);
    return said(scene);
}

TextureLayer layerOf(const char* name) {
    TextureLayer layer;
    layer.name = name;
    return layer;
}

template <class Change> QStringList withLayer(Change change) {
    return after([&](Scene& scene) {
        scene.objects[0].surfaces[0].layers = {layerOf("grain")};
        change(scene.objects[0].surfaces[0].layers[0]);
    });
}

std::shared_ptr<const Motion> sliding(double metres, double seconds, bool back) {
    Motion motion;
    motion.translation.times = {0, seconds / 2, seconds};
    motion.translation.values = {Vec3::Zero(), Vec3(metres, 0, 0),
                                 back ? Vec3(0, 0, 0) : Vec3(2 * metres, 0, 0)};
    motion.duration = seconds;
    motion.jumpsAtEnd = !back;
    return std::make_shared<const Motion>(motion);
}

} // namespace

class TestSceneSentences : public QObject {
    Q_OBJECT

private slots:
    void countsAreWrittenAsAPersonWould() {
        QCOMPARE(counted(0, "edge"), "0 edges");
        QCOMPARE(counted(1, "edge"), "1 edge");
        QCOMPARE(counted(2, "edge"), "2 edges");
        QCOMPARE(counted(1, "vertex"), "1 vertex");
        QCOMPARE(counted(7, "vertex"), "7 vertices");
        QCOMPARE(withUnit(0.0012345678, "m"), "0.00123457 m");
        QCOMPARE(withUnit(-3, ""), "-3");
        QCOMPARE(withUnit(1e9, "N/m"), "1e+09 N/m");
    }

    void theHealthOfAMesh() {
        MeshHealth health;
        std::vector<Finding> findings;
        appendHealth(findings, "rock", health);
        QVERIFY(findings.empty());
        health.components = 1; // one part is none too many
        appendHealth(findings, "rock", health);
        QVERIFY(findings.empty());
        health.slivers = 1;
        health.duplicateFaces = 2;
        health.nonManifoldEdges = 3;
        health.flippedEdges = 4;
        health.boundaryEdges = 5;
        health.holes = 1;
        health.unreferencedVertices = 6;
        health.components = 2;
        appendHealth(findings, "rock", health);
        QStringList lines;
        for (const Finding& finding : findings)
            lines << QString::fromStdString(text(finding));
        QCOMPARE(
            lines.join(u'\n'),
            "note|rock|1 triangle too thin to see|kept; merge close vertices to remove them\n"
            "warning|rock|2 triangles equal to another one|kept; remove doubles in the modelling "
            "program\n"
            "warning|rock|4 edges whose two triangles face opposite ways|kept; both sides can be "
            "touched, but "
            "make the normals consistent for shading\n"
            "note|rock|1 open rim with 5 edges|kept open; the finger can pass through if it is larger "
            "than the "
            "proxy\n"
            "note|rock|6 vertices that no face uses|ignored"); // three triangles at an edge are no trouble
        for (const Finding& finding : findings)
            QCOMPARE(saysHealth(finding), finding.remedy != "ignored"); // what no face uses is no triangle
        QVERIFY(!saysHealth({Severity::Note, "rock", "is blue", "paint it"}));
    }

    void valuesOutOfTheirRange() {
        const Parameter signs{"s", "Signed", "m", -2, 3, 0.1, 1, 2, ""},
            positive{"p", "Positive", "", 0, 3, 0.1, 1, 2, ""};
        const auto of = [](const Parameter& parameter, double value) {
            std::vector<Finding> findings;
            checkParameter(findings, "rock", " of it", parameter, value);
            return findings.empty() ? std::string() : text(findings.front());
        };
        QCOMPARE(of(signs, -2), "");
        QCOMPARE(of(signs, 3), "");
        QCOMPARE(of(signs, 3.5),
                 "warning|rock|Signed of it is 3.5 m, outside -2 to 3 m|set it inside that range; 3 m is "
                 "used when touched");
        QCOMPARE(of(signs, -2.5),
                 "warning|rock|Signed of it is -2.5 m, outside -2 to 3 m|set it inside that range; -2 m "
                 "is used when touched"); // no worse than too much
        QCOMPARE(of(positive, -1),
                 "error|rock|Positive of it is -1, outside 0 to 3|set it inside that range; 0 is used "
                 "when touched");
        QCOMPARE(of(positive, 4),
                 "warning|rock|Positive of it is 4, outside 0 to 3|set it inside that range; 3 is used "
                 "when touched");
        for (const double value : {NAN, INFINITY, -INFINITY})
            QCOMPARE(of(signs, value), "error|rock|Signed of it is not a number|set it, for example to 1 m");
    }

    void aSoundSceneIsSilent() { QCOMPARE(said(soundScene()).join(u'\n'), ""); }

    void objectsAndScene_data() {
        QTest::addColumn<QStringList>("lines");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* name, const QStringList& lines, const char* expected) {
            QTest::newRow(name) << lines << QString::fromUtf8(expected);
        };
        row("empty", said(Scene()), "warning||the scene is empty|open a model");
        row("no triangles", after([](Scene& s) { s.objects[0].geometry = std::make_shared<TriangleSoup>(); }),
            "warning|rock|has no triangles|delete it or give it a mesh");
        row("radius", after([](Scene& s) { s.proxyRadius = 0.2; }),
            "warning||Proxy radius is 0.2 m, outside 1e-05 to 0.1 m|set it inside that range; 0.1 m is used "
            "when touched\n"
            "warning|rock|is smaller (0.173205 m) than the proxy (radius 0.2 m)|scale the object up or make "
            "the proxy "
            "smaller");
        row("as large as the proxy", after([](Scene& s) {
                s.objects[0].geometry = tetrahedron(0.05);
                s.proxyRadius = 0.05 * std::sqrt(3.0) / 2 * (1 - 1e-9);
            }),
            "");
        row("large", after([](Scene& s) { s.objects[0].geometry = tetrahedron(20); }),
            "warning||the scene is 34.641 m across, which looks like another unit|scale it down, for example "
            "by 0.001 if "
            "it is in millimetres");
        row("small", after([](Scene& s) {
                s.objects[0].geometry = tetrahedron(0.001);
                s.proxyRadius = 1e-4;
            }),
            "warning||the scene is 0.00173205 m across, which looks like another unit|scale it up to fit a "
            "hand's reach");
        row("friction", after([](Scene& s) { s.objects[0].surfaces[0].material.dynamicFriction = 0.5; }),
            "warning|rock|dynamic friction of surface \"side\" (0.5) is above static friction (0)|clamped to "
            "it when "
            "touched; raise static or lower dynamic friction");
        row("one side of an uneven mesh", after([](Scene& s) {
                auto turned = tetrahedron();
                std::swap(turned->triangles[2][0], turned->triangles[2][1]);
                s.objects[0].geometry = turned;
                s.objects[0].surfaces[0].sides = Sides::Back;
            }),
            "warning|rock|3 edges whose two triangles face opposite ways|kept; both sides can be touched, "
            "but make the "
            "normals consistent for shading\n"
            "warning|rock|surface \"side\" is felt from its back alone, but neighbouring triangles face "
            "opposite ways|make "
            "the normals consistent, or let both sides be felt");
        row("moves", after([](Scene& s) { s.objects[0].motion = sliding(1, 2, true); }), "");
        row("fast", after([](Scene& s) { s.objects[0].motion = sliding(20, 2, true); }),
            "warning|rock|moves at up to 20 m/s, faster than 10 m/s|slow its animation down, or check the "
            "scene's unit");
        row("jumps", after([](Scene& s) { s.objects[0].motion = sliding(1, 2, false); }),
            "note|rock|jumps from one pose to another during its motion|what touches it there is let go; let "
            "the last "
            "pose be the first for a motion without an end");
    }

    void objectsAndScene() {
        QFETCH(QStringList, lines);
        QFETCH(QString, expected);
        QCOMPARE(lines.join(u'\n'), expected);
    }

    void layers_data() {
        QTest::addColumn<QStringList>("lines");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* name, const QStringList& lines, const char* expected) {
            QTest::newRow(name) << lines << QString::fromUtf8(expected);
        };
        row("sound", withLayer([](TextureLayer&) {}), "");
        row("off", withLayer([](TextureLayer& l) { l.enabled = false, l.opacity = 9; }), "");
        row("opacity", withLayer([](TextureLayer& l) { l.opacity = 1.5; }),
            "warning|rock|Opacity of layer \"grain\" of surface \"side\" is 1.5, outside 0 to 1|set it "
            "inside that range; "
            "1 is used when touched");
        row("own plane", withLayer([](TextureLayer& l) {
                l.target = TextureTarget::Viscosity, l.strength = 0.5, l.ownPlane = true;
            }),
            "warning|rock|own plane of layer \"grain\" of surface \"side\" means nothing: the layer is no "
            "height|switch it "
            "off");
        row("steep", withLayer([](TextureLayer& l) { l.pattern.size = 0.001, l.strength = -0.00032; }),
            "warning|rock|height of layer \"grain\" of surface \"side\" is large for its size: -0.00032 m in "
            "repeats of "
            "0.001 m|slopes above 45 degrees are cut to that; lower the height or enlarge the size");
        row("not that steep",
            withLayer([](TextureLayer& l) { l.pattern.size = 0.001, l.strength = 0.00031; }), "");
        row("no picture", withLayer([](TextureLayer& l) { l.pattern.source = TextureSource::Image; }),
            "warning|rock|image of layer \"grain\" of surface \"side\" is missing, so the layer is not "
            "felt|choose a "
            "picture, or another source");
        row("no coordinates", withLayer([](TextureLayer& l) { l.pattern.mapping = TextureMapping::UvUnit; }),
            "warning|rock|mapping of layer \"grain\" of surface \"side\" needs texture coordinates, which "
            "the mesh has not, "
            "so it is not felt|choose the triplanar mapping, or unwrap the mesh in the modelling program");
        row("no pose", withLayer([](TextureLayer& l) { l.pattern.frame.rotation = Quat(2, 0, 0, 0); }),
            "error|rock|mapping frame of layer \"grain\" of surface \"side\" is not a pose|set its position "
            "and rotation "
            "again");
        row("nowhere", withLayer([](TextureLayer& l) { l.pattern.frame.translation.x() = NAN; }),
            "error|rock|mapping frame of layer \"grain\" of surface \"side\" is not a pose|set its position "
            "and rotation "
            "again");
        row("almost a pose",
            withLayer([](TextureLayer& l) { l.pattern.frame.rotation = Quat(1.0009, 0, 0, 0); }), "");
        row("nothing painted", withLayer([](TextureLayer& l) { l.pattern.source = TextureSource::Painted; }),
            "warning|rock|nothing is painted of layer \"grain\" of surface \"side\", so it is not felt|paint "
            "it, or choose "
            "another source");
        row("painted elsewhere", withLayer([](TextureLayer& l) {
                l.pattern.source = TextureSource::Painted;
                l.pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(1));
            }),
            "warning|rock|what is painted of layer \"grain\" of surface \"side\" is of a mesh with 1 "
            "position, and this one "
            "has 4, so it is not felt|paint it again, or undo the change of the mesh");
        row("painted here", withLayer([](TextureLayer& l) {
                l.pattern.source = TextureSource::Painted;
                l.pattern.mapping = TextureMapping::Uv; // means nothing there
                l.pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(4));
            }),
            "");
        row("mask", withLayer([](TextureLayer& l) {
                l.mask = TexturePattern{};
                l.mask->source = TextureSource::Image;
                l.mask->size = 1e-9;
            }),
            "error|rock|Size of the mask of layer \"grain\" of surface \"side\" is 1e-09 m, outside 0.0001 "
            "to 10 m|set it "
            "inside that range; 0.0001 m is used when touched\n"
            "warning|rock|image of the mask of layer \"grain\" of surface \"side\" is missing, so the layer "
            "is not "
            "felt|choose a picture, or another source");
    }

    void layers() {
        QFETCH(QStringList, lines);
        QFETCH(QString, expected);
        if (qstrcmp(QTest::currentDataTag(), "mask") == 0) // the bounds are the table's own
            expected
                .replace(QStringLiteral("0.0001 to 10 m"),
                         QString::fromStdString(withUnit(kTextureSize.minimum, "") + " to " +
                                                withUnit(kTextureSize.maximum, "m")))
                .replace(QStringLiteral("range; 0.0001 m"),
                         QStringLiteral("range; ") +
                             QString::fromStdString(withUnit(kTextureSize.minimum, "m")));
        QCOMPARE(lines.join(u'\n'), expected);
    }

    void asManyLayersAsAreFelt() {
        const auto with = [](int felt, int off, int planes) {
            return after([&](Scene& scene) {
                auto& layers = scene.objects[0].surfaces[0].layers;
                layers.assign(std::size_t(felt + off), layerOf("grain"));
                for (int i = 0; i < off; ++i)
                    layers[std::size_t(felt + i)].enabled = false;
                for (int i = 0; i < planes; ++i)
                    layers[std::size_t(i)].ownPlane = true;
            });
        };
        QCOMPARE(with(16, 3, 4).join(u'\n'), "");
        QCOMPARE(with(17, 0, 0).join(u'\n'),
                 "warning|rock|surface \"side\" has 17 layers, of which 16 are felt|switch some of "
                 "them off, or bake them into one picture");
        QCOMPARE(with(6, 0, 5).join(u'\n'),
                 "warning|rock|surface \"side\" has 5 layers with a plane of its own; 4 get one|the "
                 "others join the blend; switch their own plane off");
    }
};

TACTUM_TEST(TestSceneSentences)

} // namespace test_scene_sentences

#include "test_scene_sentences.moc"
