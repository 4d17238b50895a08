// Runs the program as a person does, from outside.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>
#include <QTemporaryDir>

namespace test_program {

struct Ended {
    int code = -1;
    QByteArray out, error;
};

// No display, and a locale with a decimal comma: neither may matter to a verb.
inline Ended runTactum(const QStringList& arguments, const QString& display = {}, const QString& folder = {},
                       const QByteArray& input = {}) {
    QProcess process;
    process.setWorkingDirectory(folder);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");
    if (!display.isEmpty()) environment.insert("DISPLAY", display);
    environment.remove("WAYLAND_DISPLAY");
    environment.insert("LC_ALL", "de_DE.UTF-8");
    process.setProcessEnvironment(environment);
    process.start(TACTUM_PROGRAM, arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(120000)) return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

/// The text when it is one line, as an error has to be; else nothing.
inline QByteArray oneLine(const QByteArray& text) {
    return text.count('\n') == 1 ? text.trimmed() : QByteArray();
}

/// A folder to work in, gone with the test.
struct WorkFolder {
    QTemporaryDir folder;

    QString file(const QString& name) const { return folder.filePath(name); }
    QString write(const QString& name, const QByteArray& text) const {
        QFile out(file(name));
        if (!out.open(QIODevice::WriteOnly)) return {};
        out.write(text);
        return file(name);
    }

    // A square plate of two triangles in the plane z = 0, 0.2 m wide.
    QString plate() const {
        return write("plate.obj", "v -0.1 -0.1 0\nv 0.1 -0.1 0\nv 0.1 0.1 0\nv -0.1 0.1 0\nf 1 2 3 4\n");
    }

    // Straight down onto the plate to `depth`, then along x by `along`, at 1 kHz.
    QString pressAndSlide(double depth, double along) const {
        QByteArray text = "t,x,y,z\n";
        int row = 0;
        auto add = [&](double x, double z) {
            text += QByteArray::number(row++ * 1e-3, 'g', 17) + ',' + QByteArray::number(x, 'g', 17) +
                    ",0.003," + QByteArray::number(z, 'g', 17) + '\n';
        };
        for (int i = 0; i <= 200; ++i)
            add(0.01, 0.01 - (0.01 + depth) * i / 200.0);
        for (int i = 1; i <= 400; ++i)
            add(0.01 + along * i / 400.0, -depth);
        return write("path.csv", text);
    }
};

} // namespace test_program
