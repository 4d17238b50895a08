// Runs the program as a person does, from outside.
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>

namespace test_program { // outside of `tactum`, which is the name of the function here

struct Ended {
    int code = -1;
    QByteArray out, error;
};

// No display, and a locale with a decimal comma: neither may matter to a verb.
inline Ended tactum(const QStringList& arguments, const QString& display = {}, const QString& folder = {}) {
    QProcess process;
    process.setWorkingDirectory(folder);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");
    if (!display.isEmpty()) environment.insert("DISPLAY", display);
    environment.remove("WAYLAND_DISPLAY");
    environment.insert("LC_ALL", "de_DE.UTF-8");
    process.setProcessEnvironment(environment);
    process.start(TACTUM_PROGRAM, arguments);
    if (!process.waitForFinished(120000)) return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace test_program
