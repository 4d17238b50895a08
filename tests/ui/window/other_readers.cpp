#include "tests/ui/window/other_readers.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>

namespace tactum::test {

namespace {

constexpr int kPatienceWithOthers = 120000; // ms
constexpr const char* kThree = TACTUM_TESTS "/app/three/";

struct Ran {
    QByteArray out;
    QString fault; ///< empty: it ended well
};

Ran run(const QString& program, const QStringList& arguments, const QString& folder = {}) {
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(program, arguments);
    const bool ended = process.waitForFinished(kPatienceWithOthers);
    const QString said = QString::fromUtf8(process.readAllStandardError()).trimmed();
    if (!ended) return {{}, program + QStringLiteral(" does not come to an end: ") + said};
    const bool good = process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    return {process.readAllStandardOutput(), good ? QString() : program + QStringLiteral(": ") + said};
}

Vec3 vectorOf(const QJsonArray& numbers, int from = 0) {
    return {numbers[from].toDouble(), numbers[from + 1].toDouble(), numbers[from + 2].toDouble()};
}

ReadMaterial materialOf(const QJsonObject& json) {
    return {json["name"].toString().toStdString(), vectorOf(json["colour"].toArray()),
            json["roughness"].toDouble(-1), json["metallic"].toDouble(-1), json["bumps"].toBool()};
}

ReadObject objectOf(const QJsonObject& json) {
    ReadObject object;
    object.name = json["name"].toString().toStdString();
    const QJsonArray matrix = json["matrix"].toArray(), box = json["box"].toArray();
    for (int i = 0; i < 16; ++i)
        object.matrix[std::size_t(i)] = matrix[i].toDouble();
    object.box = {vectorOf(box), vectorOf(box, 3)};
    for (const auto& each : json["materials"].toArray())
        object.materials.push_back(materialOf(each.toObject()));
    return object;
}

/// The lines among what else a program says.
Readings told(const Ran& ran) {
    Readings readings{{}, ran.fault, {}};
    for (const QByteArray& line : ran.out.split('\n')) {
        const QJsonObject json = QJsonDocument::fromJson(line).object();
        if (!json.contains("reader")) continue;
        Reading& reading = readings.files.emplace_back(Reading{json["reader"].toString(), {}});
        for (const auto& each : json["objects"].toArray())
            reading.objects.push_back(objectOf(each.toObject()));
    }
    return readings;
}

QByteArray contentOf(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

/// Puts a file of the sources into `folder`; true when another one, or none, was there.
bool bring(const char* name, const QDir& folder) {
    const QString from = QString::fromUtf8(kThree) + QString::fromUtf8(name),
                  to = folder.filePath(QString::fromUtf8(name));
    if (QFile::exists(to) && contentOf(to) == contentOf(from)) return false;
    QFile::remove(to);
    QFile::copy(from, to);
    return true;
}

/// three.js in `folder`; else why it is not there, in one line.
QString bringThree(const QDir& folder) {
    folder.mkpath(QStringLiteral("."));
    bring("list_scene.mjs", folder);
    const bool other = bring("package.json", folder) | bring("package-lock.json", folder);
    if (!other && folder.exists(QStringLiteral("node_modules/three/package.json"))) return {};
    const QString npm = QStandardPaths::findExecutable(QStringLiteral("npm"));
    if (npm.isEmpty()) return QStringLiteral("three.js is not here: npm, which brings it, is not installed");
    const Ran ran = run(npm, {"ci", "--ignore-scripts", "--no-audit", "--no-fund"}, folder.path());
    if (ran.fault.isEmpty()) return {};
    QFile::remove(folder.filePath(QStringLiteral("package.json"))); // to be tried again
    return QStringLiteral("three.js is not here, and cannot be fetched: ") + ran.fault.simplified();
}

} // namespace

Readings readByThree(const QStringList& files) {
    const QString node = QStandardPaths::findExecutable(QStringLiteral("node"));
    if (node.isEmpty()) return {QStringLiteral("Node.js is not installed, which runs three.js"), {}, {}};
    const QDir folder(QStringLiteral(TACTUM_THREE));
    if (const QString missing = bringThree(folder); !missing.isEmpty()) return {missing, {}, {}};
    return told(run(node, QStringList{folder.filePath(QStringLiteral("list_scene.mjs"))} + files));
}

Readings readByBlender(const QStringList& files) {
    const QString blender = QStandardPaths::findExecutable(QStringLiteral("blender"));
    if (blender.isEmpty()) return {QStringLiteral("Blender is not installed"), {}, {}};
    return told(run(blender, QStringList{"-b", "--factory-startup", "--python-exit-code", "1", "--python",
                                         TACTUM_TESTS "/app/blender/list_scene.py", "--"} +
                                 files));
}

} // namespace tactum::test
