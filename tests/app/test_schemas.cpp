// What the verbs write as JSON is what docs/schema says, member by member.
#include <algorithm>

#include <QTest>

#include "tests/app/json_schema.h"
#include "tests/app/program.h"
#include "tests/support/test_program.h"

namespace test_schemas {

using namespace test_program;

namespace {

const QString kScenes = TACTUM_ROOT "/resources/scenes/";

JsonSchema schemaOf(const QString& name) {
    QFile file(TACTUM_ROOT "/docs/schema/" + name + ".schema.json");
    return JsonSchema(file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray());
}

QJsonValue jsonOf(const QByteArray& text) {
    const QJsonDocument document = QJsonDocument::fromJson(text);
    return document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object());
}

} // namespace

class TestSchemas : public QObject {
    Q_OBJECT

    WorkFolder folder_;

    void fits(const char* schema, const QByteArray& text) {
        const JsonSchema wanted = schemaOf(schema);
        QVERIFY2(wanted.isThere(), schema);
        const QString fault = wanted.faultOf(jsonOf(text));
        QVERIFY2(fault.isEmpty(), qPrintable(schema + (": " + fault)));
    }

private slots:
    void infoIsAsItsSchema() {
        for (const char* scene :
             {"teapot.glb", "layered-leather.glb", "moving/crank.glb", "moving/roller-coaster.glb"})
            fits("info", runTactum({"info", "--json", kScenes + scene}).out);
        fits("info", runTactum({"info", "--json", kScenes + "teapot.glb", kScenes + "teapot.obj"}).out);
        fits("info", runTactum({"info", "--json", kScenes + "teapot.glb", "no-such.obj"}).out);
        fits("info", runTactum({"info", "--json", "no-such.obj"}).out);
    }

    void checkIsAsItsSchema() {
        fits("check", runTactum({"check", "--json", kScenes + "teapot.glb", kScenes + "teapot.obj"}).out);
        fits("check", runTactum({"check", "--json", "--strict", folder_.plate()}).out);
        fits("check", runTactum({"check", "--json", "no-such.obj", folder_.plate()}).out);
    }

    void touchIsAsItsSchema() {
        fits("touch",
             runTactum({"touch", folder_.plate(), "--path", folder_.pressAndSlide(0.001, 0.01)}).out);
        const QString path = folder_.pressAndSlide(0.001, 0.01);
        fits("touch", runTactum({"touch", folder_.plate(), "--path", path, "--path", path}).out);
    }

    void reportsAreAsTheirSchema() {
        for (const char* ending : {"glb", "x3d", "obj", "ply", "stl", "off"}) {
            const QString report = folder_.file("report.json");
            QCOMPARE(runTactum({"convert", kScenes + "layered-leather.glb", folder_.file("out.") + ending,
                                "--report", report})
                         .code,
                     0);
            QFile file(report);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray text = file.readAll();
            QVERIFY(jsonOf(text).isArray());
            fits("convert-report", text);
        }
    }

    /// The one that judges sees what is wrong.
    void whatDoesNotFitIsFound() {
        const JsonSchema check = schemaOf("check");
        QJsonObject good = jsonOf(runTactum({"check", "--json", folder_.plate()}).out).toObject();
        QCOMPARE(check.faultOf(good), QString());
        for (const auto& [key, wrong] : {std::pair<QString, QJsonValue>{"version", 2},
                                         {"ok", "yes"},
                                         {"more", 1},
                                         {"files", QJsonArray{1}},
                                         {"files", QJsonArray{QJsonObject{{"file", "a"}}}}}) {
            QJsonObject bad = good;
            bad[key] = wrong;
            QVERIFY2(!check.faultOf(bad).isEmpty(), qPrintable(key));
        }
    }
};

TACTUM_TEST(TestSchemas)

} // namespace test_schemas

#include "test_schemas.moc"
