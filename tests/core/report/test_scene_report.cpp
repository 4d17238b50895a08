// The report of a scene, as Python's own parser of HTML reads it: values are the scene's, nothing of it is
// markup.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cmath>

#include "core/files/load_scene.h"
#include "core/presets/preset_file.h"
#include "core/report/scene_report.h"
#include "core/scene/primitives.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_report {

using namespace tactum;
using namespace tactum::test;

namespace {

/// As read_report.py has it.
struct ReadReport {
    QByteArray html;
    QJsonObject read;

    /// Rows of all tables that begin with this cell.
    QList<QStringList> rowsOf(const QString& first) const {
        QList<QStringList> rows;
        for (const QJsonValue& table : read["tables"].toArray())
            for (const QJsonValue& row : table.toArray())
                if (row.toArray()[0].toString() == first) rows << row.toVariant().toStringList();
        return rows;
    }
    QStringList faults() const { return read["faults"].toVariant().toStringList(); }
    QStringList pictures() const {
        QStringList words;
        for (const QJsonValue& picture : read["pictures"].toArray())
            words << picture["kind"].toString() + QStringLiteral(": ") + picture["alt"].toString();
        return words;
    }
};

Scene plate() {
    Scene scene = sceneOf(Primitive::Plate);
    scene.objects.front().name = "plate";
    scene.objects.front().surfaces.front().name = "top";
    return scene;
}

} // namespace

class TestSceneReport : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    ReadReport reportOf(const ReportSubject& subject) {
        const auto html = sceneReport(subject);
        if (!html) qFatal("%s", html.error().text.c_str());
        QFile file(folder_.filePath(QStringLiteral("report.html")));
        if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
        file.write(html->data(), qint64(html->size()));
        file.close();
        QProcess python;
        python.start(QStringLiteral("/usr/bin/python3"), {TACTUM_REPORT_READER, file.fileName()});
        if (!python.waitForFinished(60000) || python.exitCode() != 0)
            qFatal("%s", python.readAllStandardError().constData());
        return {QByteArray::fromStdString(*html),
                QJsonDocument::fromJson(python.readAllStandardOutput()).object()};
    }
    static ReportSubject subjectOf(const Scene& scene) {
        return {scene, "plate.glb", "0123abcd", "0.1.0", "2026-11-26 12:00 UTC"};
    }

private slots:
    void itIsAPageWithoutFaults();
    void valuesAreTheScenes();
    void sourcesAreThePresets();
    void namesOfStrangersAreText();
    void layersComeWithPictures();
    void bodiesProblemsAndDeviceAreInIt();
    void aStrokeIsDrawn();
    void theSameSceneGivesTheSameBytes();
    void itsDateCanBeGiven();
    void whoCancelsGetsNone();
};

void TestSceneReport::itIsAPageWithoutFaults() {
    for (const char* name : {"teapot.glb", "texture-wall.glb", "moving/crank.glb", "layered-leather.glb"}) {
        const auto loaded = loadScene(std::filesystem::path(TACTUM_SCENES) / name);
        VERIFY_RESULT(loaded);
        const ReadReport report = reportOf(subjectOf(loaded->scene));
        QCOMPARE(report.faults(), QStringList());
        COMPARE_CONTAINS(report.html, "color-scheme: light dark");
        QVERIFY(!report.html.contains("http://www.w3.org/1999/xhtml"));
    }
}

void TestSceneReport::valuesAreTheScenes() {
    Scene scene = plate();
    Material& material = scene.objects.front().surfaces.front().material;
    material.stiffness = 350.5;
    material.staticFriction = 0.62;
    scene.objects.front().surfaces.front().shading.on = true;
    const ReadReport report = reportOf(subjectOf(scene));
    QCOMPARE(report.read["title"].toString(), QStringLiteral("plate.glb"));
    QCOMPARE(report.rowsOf(QStringLiteral("plate: top")),
             (QList<QStringList>{{"plate: top", "Stiffness", "350.5", "N/m", "800", ""},
                                 {"plate: top", "Static friction", "0.62", "", "0", ""},
                                 {"plate: top", "Force shading", "crease angle 50", "\u00b0", "off", ""}}));
    QCOMPARE(report.rowsOf(QStringLiteral("File's SHA-256")),
             (QList<QStringList>{{"File's SHA-256", "0123abcd"}}));
    QCOMPARE(report.rowsOf(QStringLiteral("Size")), (QList<QStringList>{{"Size", "120 x 8 x 120 mm"}}));
    const auto reachOf = [&](const Reach& reach) {
        Scene reaching = scene;
        reaching.reach = reach;
        return reportOf(subjectOf(reaching)).rowsOf(QStringLiteral("Reach of the hand")).value(0).value(1);
    };
    QCOMPARE(reachOf({}), QStringLiteral("as far as the device's workspace"));
    QCOMPARE(reachOf({ReachMode::Drift, 0.02}), QStringLiteral("Drift"));
    QCOMPARE(reachOf({ReachMode::Rate, 0.02}), QStringLiteral("Rate control beyond the shell, 20 mm"));
    scene.objects.front().surfaces.front() = Surface();
    scene.objects.front().surfaces.front().name = "top";
    COMPARE_CONTAINS(reportOf(subjectOf(scene)).rowsOf(QStringLiteral("plate: top")).front().join(u' '),
                     QStringLiteral("everything by default"));
}

void TestSceneReport::sourcesAreThePresets() {
    const auto brick = readPreset(std::filesystem::path(TACTUM_PRESETS) / "brick.tactum-preset");
    VERIFY_RESULT(brick);
    const std::vector<Preset> presets{brick->preset};
    Scene scene = plate();
    Surface& surface = scene.objects.front().surfaces.front();
    surface = applied(surface, presets.front());
    ReportSubject subject = subjectOf(scene);
    subject.presets = presets;
    const auto sourceOfFriction = [&] {
        for (const QStringList& row : reportOf(subject).rowsOf(QStringLiteral("plate: top")))
            if (row[1] == QStringLiteral("Dynamic friction")) return row[5];
        return QString();
    };
    const QString words = QString::fromStdString(sourceOf(presets.front(), "dynamicFriction").words);
    QVERIFY(!words.isEmpty());
    COMPARE_CONTAINS(sourceOfFriction(), QStringLiteral("Preset Brick: ") + words);
    // What was changed since is nobody's.
    surface.material.dynamicFriction -= 0.01;
    QCOMPARE(sourceOfFriction(), QString());
}

void TestSceneReport::namesOfStrangersAreText() {
    Scene scene = plate();
    const std::string evil = "<script>alert('x')</script>\" onload=\"x&amp;";
    scene.objects.front().name = evil;
    scene.objects.front().surfaces.front().name = evil;
    TextureLayer layer;
    layer.name = evil;
    scene.objects.front().surfaces.front().layers.push_back(layer);
    ReportSubject subject = subjectOf(scene);
    subject.name = evil;
    subject.device = ReportDevice{evil, 8, 0, 0};
    const ReadReport report = reportOf(subject);
    QCOMPARE(report.faults(), QStringList());
    COMPARE_LACKS(report.html, "<script");
    const QString text = QString::fromStdString(evil);
    QCOMPARE(report.read["title"].toString(), text);
    QVERIFY(!report.rowsOf(text + QStringLiteral(": ") + text).isEmpty());
}

void TestSceneReport::layersComeWithPictures() {
    const auto loaded = loadScene(std::filesystem::path(TACTUM_SCENES) / "texture-wall.glb");
    VERIFY_RESULT(loaded);
    const ReadReport report = reportOf(subjectOf(loaded->scene));
    std::size_t layers = 0;
    for (const SceneObject& object : loaded->scene.objects)
        for (const Surface& surface : object.surfaces)
            for (const TextureLayer& layer : surface.layers) {
                ++layers;
                const auto rows = report.rowsOf(QString::fromStdString(layer.name));
                QVERIFY2(!rows.isEmpty(), layer.name.c_str());
                if (layer.target == TextureTarget::Height)
                    COMPARE_CONTAINS(rows.front()[4], QStringLiteral(" mm"));
                COMPARE_CONTAINS(report.pictures().join(u'\n'),
                                 QStringLiteral("image/png: Layer ") + QString::fromStdString(layer.name));
            }
    QVERIFY(layers > 2);
    COMPARE_CONTAINS(report.pictures(),
                     QStringLiteral("image/png: The scene, seen from the front, the right and above"));
}

void TestSceneReport::bodiesProblemsAndDeviceAreInIt() {
    const auto loaded = loadScene(std::filesystem::path(TACTUM_SCENES) / "moving/crank.glb");
    VERIFY_RESULT(loaded);
    Scene scene = loaded->scene;
    scene.objects.front().surfaces.front().material.stiffness = 1e6; // far beyond its range
    ReportSubject subject = subjectOf(scene);
    subject.device = ReportDevice{"Novint Falcon", 8.5, 2000, 1210};
    const ReadReport report = reportOf(subject);
    for (const RigidBody& body : scene.mechanics.bodies)
        QVERIFY2(!report.rowsOf(QString::fromStdString(body.name)).isEmpty(), body.name.c_str());
    for (const Joint& joint : scene.mechanics.joints)
        QVERIFY2(!report.rowsOf(QString::fromStdString(joint.name)).isEmpty(), joint.name.c_str());
    bool told = false;
    for (const QStringList& row : report.rowsOf(QString::fromStdString(scene.objects.front().name)))
        told = told || row.value(2).contains(QStringLiteral("stiffness"), Qt::CaseInsensitive);
    QVERIFY(told);
    QCOMPARE(report.rowsOf(QStringLiteral("Device")), (QList<QStringList>{{"Device", "Novint Falcon"}}));
    QCOMPARE(report.rowsOf(QStringLiteral("Largest force")),
             (QList<QStringList>{{"Largest force", "8.5 N"}}));
    COMPARE_CONTAINS(report.html, "1210 N/m");
}

void TestSceneReport::aStrokeIsDrawn() {
    Scene scene = plate();
    const ReadReport report = reportOf(subjectOf(scene));
    COMPARE_CONTAINS(report.pictures().back(),
                     QStringLiteral("image/svg+xml: The force over time. The largest"));
    // Straight down onto a plate the spring is all there is.
    const QString words = report.pictures().back();
    const double most = words.section(QStringLiteral("force is "), 1).section(u' ', 0, 0).toDouble();
    const double diagonal = 1e-3 * std::sqrt(120 * 120 + 8 * 8 + 120 * 120);
    COMPARE_NEAR(most, kStiffness.initial * 0.01 * diagonal, 0.05, "N");
    // A path that goes nowhere near.
    scene.finger = std::make_shared<const std::vector<FingerPoint>>(
        std::vector<FingerPoint>{{0, Vec3(9, 9, 9)}, {0.001, Vec3(9, 9, 9)}});
    COMPARE_CONTAINS(reportOf(subjectOf(scene)).html, "own finger path. It touches nothing.");
}

void TestSceneReport::theSameSceneGivesTheSameBytes() {
    const Scene scene = plate();
    QCOMPARE(reportOf(subjectOf(scene)).html, reportOf(subjectOf(scene)).html);
}

void TestSceneReport::itsDateCanBeGiven() {
    qputenv("SOURCE_DATE_EPOCH", "1700000000");
    QCOMPARE(reportDate(), std::string("2023-11-14 22:13 UTC"));
    qunsetenv("SOURCE_DATE_EPOCH");
    COMPARE_LACKS(reportDate(), "2023-");
}

void TestSceneReport::whoCancelsGetsNone() {
    const std::atomic<bool> cancelled = true;
    const Scene scene = plate();
    COMPARE_CONTAINS(refusal(sceneReport(subjectOf(scene), {{}, &cancelled})), "cancelled");
}

TACTUM_TEST(TestSceneReport)

} // namespace test_scene_report

#include "test_scene_report.moc"
