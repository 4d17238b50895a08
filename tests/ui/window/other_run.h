// Another run of a test's own program, which edits a scene until it is killed.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QTest>

#include "core/files/gltf/write_gltf.h"
#include "core/files/journal.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/journal.h"

namespace tactum {

inline void setStiffness(Document& document, double stiffness, Gesture gesture = 0) {
    const SurfaceRef first{document.scene().objects.front().id, 0};
    for (const MaterialField& field : kMaterialFields)
        if (field.parameter == &kStiffness) document.setMaterialValue(first, field, stiffness, gesture);
}

inline void write(const QString& file, const std::string& bytes) {
    QFile out(file);
    if (!out.open(QIODevice::WriteOnly) || out.write(bytes.data(), qint64(bytes.size())) < 0)
        qFatal("%s cannot be written", qPrintable(file));
}

inline QByteArray read(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

inline std::vector<std::filesystem::path> journals() {
    std::vector<std::filesystem::path> found;
    std::error_code fault;
    for (const auto& each : std::filesystem::directory_iterator(Journal::home(), fault))
        found.push_back(each.path());
    return found;
}

/// The program that is killed: opens a scene, edits it, takes the last edit back as the one that makes them
/// `edits`, says what it has, and goes on until then.
inline int editUntilKilled(const QString& settings, const QString& scene, int edits) {
    useSettingsIn(settings);
    TouchedWindow program;
    if (!program.open(scene)) return 2;
    for (int i = 1; i < edits; ++i)
        setStiffness(program.document, 100 + i);
    program.document.history().undo();
    write(settings + QStringLiteral("/edited.glb"), *glbOf(program.document.scene()));
    for (;;)
        program.frames(10);
}

/// Another run of this program, whose data are in the same folder.
class OtherRun {
public:
    OtherRun(const QString& settings, const QString& scene, int edits) {
        process_.setProcessChannelMode(QProcess::ForwardedChannels);
        process_.start(QCoreApplication::applicationFilePath(),
                       {QString::fromStdString(test::runningTest()), QStringLiteral("--edit"), settings,
                        scene, QString::number(edits)});
    }
    ~OtherRun() { kill(); }
    bool waitForJournals(std::size_t count) {
        return test::waitFor([&] {
            const auto all = journals();
            return std::size_t(std::ranges::count_if(all, holdsJournal)) == count;
        });
    }
    void kill() {
        process_.kill();
        process_.waitForFinished();
    }
    qint64 pid() const { return process_.processId(); }

private:
    QProcess process_;
};

/// What a test's instead() returns: this process is the other run when its arguments say so.
inline std::optional<int> asOtherRun() {
    const QStringList words = QCoreApplication::arguments();
    if (words.value(1) != QLatin1String("--edit")) return std::nullopt;
    return editUntilKilled(words[2], words[3], words[4].toInt());
}

} // namespace tactum
