#include "tests/ui/window/study_pictures.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QTest>
#include <QTimer>

#include "tests/ui/window/window_fixture.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_session.h"

namespace tactum {

namespace {

void save(QWidget& shown, const QDir& folder, const char* name) {
    const QString file = folder.filePath(QLatin1String(name));
    if (!shown.grab().save(file)) qFatal("%s cannot be written", qPrintable(file));
    qInfo("%s", qPrintable(file));
}

/// Takes the next dialog's picture and agrees to it.
void takeDialog(const QDir& folder, const char* name) {
    QTimer::singleShot(500, [folder, name] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog) qFatal("no dialog");
        save(*dialog, folder, name);
        dialog->accept();
    });
}

void makeStudy(TouchedWindow& program, const QString& file) {
    StudyDesk& desk = program.window->studyDesk();
    program.type(QStringLiteral("stiffness"), QStringLiteral("400"));
    desk.keep(QStringLiteral("glazed"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.60"));
    desk.keep(QStringLiteral("bare clay"));
    StudyDesign design = desk.study().design;
    design.name = "Clay";
    design.procedure = Procedure::Abx;
    design.repeats = 12;
    design.instructions = "You will touch three pots: A, B and X.\nX is the same as A or the same as B.";
    design.questions = {{StudyQuestion::Kind::Rating, "How sure are you?", "guessed", "certain", 5, {}}};
    desk.setDesign(design);
    desk.save(file);
    if (!test::waitFor([&] { return !desk.working() && !desk.modified(); })) qFatal("the study is not saved");
}

} // namespace

void takeStudyPictures(const QDir& folder, const QString& sample, QSize size) {
    const QTemporaryDir scratch;
    TouchedWindow program(size);
    if (!program.open(sample)) qFatal("%s cannot be opened", qPrintable(sample));
    makeStudy(program, scratch.filePath(QStringLiteral("clay.tactum-study")));
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-study"))->raise();
    program.frames(30);
    save(*program.window, folder, "study-dock.png");
    takeDialog(folder, "study-procedure.png");
    program.command("study-edit").trigger();
    takeDialog(folder, "study-run.png");
    program.command("study-run").trigger();
    StudySession& study = program.window->study();
    const auto press = [](Qt::Key key) {
        if (!test::waitFor([] { return QApplication::focusWidget() != nullptr; }))
            qFatal("nobody has the keys");
        QTest::keyClick(QApplication::focusWidget(), key);
    };
    program.frames(30);
    save(*program.window, folder, "study-welcome.png");
    for (int interval = 0; interval < 3; ++interval) {
        if (!test::waitFor([&] {
                if (study.run().step() == StudyStep::Instructions) press(Qt::Key_Space);
                return study.felt();
            }))
            qFatal("no stimulus");
        if (interval == 2) {
            program.press(program.centre());
            if (!test::waitFor([&] { return program.touch().contacts > 0; }) || !program.atRest())
                qFatal("no touch");
            save(*program.window, folder, "study-trial.png");
            program.release(program.centre());
        }
        press(Qt::Key_Space);
    }
    program.frames(10);
    save(*program.window, folder, "study-choice.png");
    press(Qt::Key_A);
    program.frames(10);
    save(*program.window, folder, "study-question.png");
    study.end();
}

} // namespace tactum
