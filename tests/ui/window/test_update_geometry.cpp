// Shapes that another program has changed: taken by a command or when the file changes, with the feel by
// names.
#include <QAbstractButton>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QPointer>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "core/scene/bodies.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/obj_box.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/source_watch.h"

namespace test_update_geometry {

using namespace tactum;

namespace {

/// A pot and something beside it, so many metres high.
QByteArray potText(double high, const char* beside = "lid") {
    int next = 1;
    QByteArray text = objBox("pot", {-0.05, 0, -0.05}, {0.05, high, 0.05}, next);
    text += objBox(beside, {0.07, 0, -0.02}, {0.11, 0.02, 0.02}, next);
    return text;
}

const SceneObject& object(const TouchedWindow& program, std::size_t i) {
    return program.document.scene().objects[i];
}

double highOf(const TouchedWindow& program) {
    return boundsOf(*object(program, 0).geometry).high.y();
}

QString noticeOf(const TouchedWindow& program) {
    const auto* label = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    return label->isVisible() ? label->text() : QString();
}

QAbstractButton& act(const TouchedWindow& program) {
    return *program.window->findChild<QAbstractButton*>(QStringLiteral("notice-act"));
}

void setStiffness(TouchedWindow& program, std::size_t i, double stiffness) {
    for (const MaterialField& field : kMaterialFields)
        if (field.parameter->key == "stiffness")
            program.document.setMaterialValue(SurfaceRef{object(program, i).id, 0}, field, stiffness);
}

} // namespace

class TestUpdateGeometry : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

    QString write(const QString& name, const QByteArray& text) const {
        return writeFile(*folder_, name, text);
    }
    /// Waits for its end, which may be an error.
    bool update(TouchedWindow& program, const QString& file) {
        QSignalSpy ended(&program.document, &Document::editEnded);
        program.document.updateGeometry(file.toStdString());
        return test::waitFor([&] { return ended.size() == 1 && program.caughtUp(); });
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        useSettingsIn(folder_->path());
    }

    void newShapesFeelAsTheOldOnes() {
        TouchedWindow program;
        QVERIFY(program.open(write(QStringLiteral("pot.obj"), potText(0.08))));
        setStiffness(program, 0, 321);
        program.document.editScene(QStringLiteral("Move"), SceneChange::What::Objects, [](Scene& scene) {
            scene.objects[0].pose.translation = {0, 0.01, 0};
        });
        const Scene before = program.document.scene();
        const int steps = program.document.history().count();
        QString offered;
        const QString file = write(QStringLiteral("pot.obj"), potText(0.12, "spoon"));
        answerFileDialog(file, &offered);
        QSignalSpy updated(&program.document, &Document::geometryUpdated);
        QTest::keyClick(program.window.get(), Qt::Key_U, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(updated.size(), 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp(), kPatience);
        QCOMPARE(QDir(offered), QDir(folder_->path())); // where the model is from
        COMPARE_NEAR(highOf(program), 0.12, 1e-9, "m");
        QCOMPARE(object(program, 0).surfaces[0].material.stiffness, 321.0);
        COMPARE_NEAR(object(program, 0).pose.translation, Vec3(0, 0.01, 0), 1e-12, "m");
        QCOMPARE(program.document.history().count(), steps + 1);
        QCOMPARE(program.document.history().undoText(), "Update geometry from pot.obj");
        QCOMPARE(noticeOf(program), "The shapes are those of pot.obj now. 1 of 2 surfaces is not there any "
                                    "more, 1 surface has no feel from here.");
        // What found no partner, on either side.
        QCOMPARE(act(program).text(), "What is not as before");
        QTest::mouseClick(&act(program), Qt::LeftButton);
        auto* list = program.window->findChild<QDialog*>(QStringLiteral("finding-list"));
        QVERIFY(list && list->isVisible());
        QStringList rows;
        auto* tree = list->findChild<QTreeWidget*>();
        for (int i = 0; i < tree->topLevelItemCount(); ++i)
            rows << tree->topLevelItem(i)->text(0);
        COMPARE_CONTAINS(rows.join(u'\n'), "spoon: surface ");
        COMPARE_CONTAINS(rows.join(u'\n'), "lid: surface ");
        const QPointer<QDialog> shown = list;
        program.window->activateWindow();
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(program.document.scene() == before);
        QVERIFY(!shown || !shown->isVisible()); // everything is as before
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        COMPARE_NEAR(highOf(program), 0.12, 1e-9, "m");
    }

    /// In millimetres with z up, and too large for a hand: what was chosen and done at the opening holds.
    void theNewFileIsTakenAsTheOldOneWas() {
        TouchedWindow program;
        const auto text = [](double high) {
            int next = 1;
            return objBox("pot", {0, 0, 0}, {900, 900, high}, next);
        };
        QVERIFY(program.open(write(QStringLiteral("pot.obj"), text(900))));
        program.document.reopen({1e-3, true});
        QTRY_VERIFY_WITH_TIMEOUT(!program.document.opening() && program.caughtUp(), kPatience);
        const double edge = 0.2 / std::sqrt(3.0);
        COMPARE_NEAR(boundsOf(program.document.scene()).high, Vec3::Constant(edge / 2).eval(), 1e-9, "m");
        QVERIFY(update(program, write(QStringLiteral("pot.obj"), text(1800))));
        const Bounds box = boundsOf(program.document.scene());
        COMPARE_NEAR(Vec3(box.high - box.low), Vec3(edge, 2 * edge, edge), 1e-9, "m");
        COMPARE_NEAR(box.low, Vec3::Constant(-edge / 2).eval(), 1e-9,
                     "m"); // it grew upward from where it stands
        // The same once more after an undo: the first file is the one before.
        program.document.history().undo();
        QVERIFY(update(program, write(QStringLiteral("pot.obj"), text(450))));
        COMPARE_NEAR(boundsOf(program.document.scene()).high.y(), 0, 1e-9, "m");
    }

    /// Exported in metres this time: by the unit of the opening it would be too small to be seen.
    void anotherUnitIsNoticedByTheSize() {
        TouchedWindow program;
        const auto text = [](double size) {
            int next = 1;
            return objBox("part", {0, 0, 0}, {0.1 * size, 0.08 * size, 0.06 * size}, next);
        };
        const QString file = write(QStringLiteral("part.obj"), text(1000));
        QVERIFY(program.open(file));
        program.document.reopen({1e-3, true});
        QTRY_VERIFY_WITH_TIMEOUT(!program.document.opening() && program.caughtUp(), kPatience);
        setStiffness(program, 0, 321);
        const Vec3 size(0.1, 0.06, 0.08); // z is up
        const auto sizeNow = [&] {
            const Bounds box = boundsOf(program.document.scene());
            return Vec3(box.high - box.low);
        };
        COMPARE_NEAR(sizeNow(), size, 1e-9, "m");
        const auto& bar = *program.window->findChild<QWidget*>(QStringLiteral("import"));
        QVERIFY(!bar.isVisible());
        QVERIFY(update(program, write(QStringLiteral("part.obj"), text(1))));
        COMPARE_NEAR(sizeNow(), size, 1e-9, "m");
        QCOMPARE_EQ(object(program, 0).surfaces[0].material.stiffness, 321.0);
        COMPARE_CONTAINS(noticeOf(program),
                         "One unit is taken as 1 m and no longer as 1 mm, by which it would "
                         "be 1000 times smaller than before.");
        QVERIFY(bar.isVisible());
        const auto unit = [&](const char* name) {
            return program.window->findChild<QAbstractButton*>(QLatin1String(name));
        };
        QVERIFY(unit("import-unit-m")->isChecked());
        QVERIFY(unit("import-up-z")->isChecked());
        QSignalSpy updated(&program.document, &Document::geometryUpdated);
        QTest::mouseClick(unit("import-unit-mm"), Qt::LeftButton); // it was meant so
        QTRY_COMPARE_WITH_TIMEOUT(updated.size(), 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp(), kPatience);
        COMPARE_NEAR(sizeNow(), (1e-3 * size).eval(), 1e-9, "m");
        QCOMPARE_EQ(object(program, 0).surfaces[0].material.stiffness, 321.0);
        QVERIFY(unit("import-unit-mm")->isChecked());
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
        COMPARE_NEAR(sizeNow(), size, 1e-9, "m");
        QVERIFY(!bar.isVisible()); // what can be done again would be lost
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(update(program, write(QStringLiteral("part.obj"), text(2000))));
        COMPARE_NEAR(sizeNow(), (2 * size).eval(), 1e-9, "m"); // that may be meant
        QVERIFY(!bar.isVisible());
    }

    /// A file whose end is not there yet, or an export of half a model.
    void whatIsMissingIsSaidAndItsFeelWaits() {
        TouchedWindow program;
        QVERIFY(program.open(write(QStringLiteral("pot.obj"), potText(0.08))));
        setStiffness(program, 0, 321);
        setStiffness(program, 1, 222);
        program.document.editScene(QStringLiteral("Bodies"), SceneChange::What::Bodies,
                                   [](Scene& scene) { makeBody(scene, scene.objects[0].id); });
        const Scene before = program.document.scene();
        int next = 1;
        const QByteArray half = objBox("pot", {-0.05, 0, -0.05}, {0.05, 0.08, 0.05}, next);
        QVERIFY(update(program, write(QStringLiteral("pot.obj"), half)));
        QCOMPARE(noticeOf(program), "The shapes are those of pot.obj now. 1 of 2 surfaces is not there any "
                                    "more, 1 body was left out.");
        auto& undo = *program.window->findChild<QAbstractButton*>(QStringLiteral("notice-also"));
        QVERIFY(undo.isVisible());
        QCOMPARE(undo.text(), "Undo");
        QCOMPARE_GT(program.window->findChild<QLabel*>(QStringLiteral("notice-text"))->width(), 200);
        QTest::mouseClick(&undo, Qt::LeftButton);
        QVERIFY(program.document.scene() == before);
        QVERIFY(noticeOf(program).isEmpty());
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(program.document.scene().objects.size(), std::size_t(1));
        QVERIFY(update(program, write(QStringLiteral("pot.obj"), potText(0.08))));
        QCOMPARE_EQ(object(program, 0).surfaces[0].material.stiffness, 321.0);
        QCOMPARE_EQ(object(program, 1).surfaces[0].material.stiffness, 222.0);
        QCOMPARE(noticeOf(program),
                 "The shapes are those of pot.obj now. 1 surface came back with the feel of "
                 "before. They feel as before.");
        // Another edit after an update: Undo would be about that.
        QVERIFY(update(program, write(QStringLiteral("pot.obj"), half)));
        QVERIFY(undo.isVisible());
        setStiffness(program, 0, 500);
        QVERIFY(!undo.isVisible());
        QVERIFY(act(program).isVisible());
    }

    void aBrokenFileIsOneLineAndNoHarm() {
        TouchedWindow program;
        QVERIFY(program.open(write(QStringLiteral("pot.obj"), potText(0.08))));
        setStiffness(program, 0, 321); // else any surface of that name would do
        const Scene before = program.document.scene();
        QVERIFY(update(program, write(QStringLiteral("torn.ply"), "ply\nformat")));
        COMPARE_CONTAINS(noticeOf(program), "torn.ply");
        QVERIFY(!noticeOf(program).contains(u'\n'));
        QVERIFY(program.document.scene() == before);
        QCOMPARE(program.document.history().count(), 1);
        int next = 1;
        const QByteArray stranger =
            objBox("fork", {0, 0, 0}, {0.1, 0.1, 0.1}, next) + objBox("knife", {1, 0, 0}, {2, 1, 1}, next);
        QVERIFY(update(program, write(QStringLiteral("fork.obj"), stranger)));
        COMPARE_CONTAINS(noticeOf(program), "no surface has the name of one");
        QVERIFY(program.document.scene() == before);
    }

    void aFileThatAnotherProgramWritesIsOffered() {
        TouchedWindow program;
        QVERIFY(program.open(write(QStringLiteral("pot.obj"), potText(0.08))));
        setStiffness(program, 1, 222);
        write(QStringLiteral("pot.obj"), potText(0.1));
        const auto isOffered = [&] { return act(program).isVisible(); };
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
        COMPARE_CONTAINS(noticeOf(program), "pot.obj was changed by another program");
        QCOMPARE(act(program).text(), "Update geometry");
        QCOMPARE(program.document.history().count(), 1); // nothing happens by itself
        QSignalSpy updated(&program.document, &Document::geometryUpdated);
        QTest::mouseClick(&act(program), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(updated.size(), 1, kPatience);
        COMPARE_NEAR(highOf(program), 0.1, 1e-9, "m");
        QCOMPARE(object(program, 1).surfaces[0].material.stiffness, 222.0);
        QTRY_VERIFY_WITH_TIMEOUT(noticeOf(program).contains(QStringLiteral("and feel as before")), kPatience);
        QVERIFY(!isOffered());
        // Many programs write beside it and put that in its place, some a while after they removed it.
        const auto* settling = program.window->findChild<SourceWatch*>()->findChild<QTimer*>();
        QCOMPARE_GE(settling->interval(), 1000); // as long as nobody writes in between
        QSignalSpy looked(settling, &QTimer::timeout);
        const QString part = write(QStringLiteral("pot.obj.part"), potText(0.14));
        QVERIFY(QFile::remove(folder_->filePath(QStringLiteral("pot.obj"))));
        QTRY_VERIFY_WITH_TIMEOUT(!looked.isEmpty() && !settling->isActive(), kPatience);
        QVERIFY(!isOffered());
        QVERIFY(QFile::rename(part, folder_->filePath(QStringLiteral("pot.obj"))));
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
        QTest::mouseClick(&act(program), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(updated.size(), 2, kPatience);
        COMPARE_NEAR(highOf(program), 0.14, 1e-9, "m");
    }

    /// The model stays the source when the scene gets a file of its own; a scene's own file is its source.
    void ourOwnSavesAreNoNews() {
        TouchedWindow program;
        QVERIFY(program.open(write(QStringLiteral("pot.obj"), potText(0.08))));
        const std::string own = folder_->filePath(QStringLiteral("own.glb")).toStdString();
        QSignalSpy saved(&program.document, &Document::saved);
        program.document.save(own);
        QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
        QCOMPARE(program.document.source().path.filename().string(), std::string("pot.obj"));
        QVERIFY(program.open(QString::fromStdString(own)));
        SourceWatch watch(program.document);
        emit program.document.opened(); // it is late
        QSignalSpy changed(&watch, &SourceWatch::changed);
        for (int i = 0; i < 3; ++i) {
            setStiffness(program, 0, 300 + i);
            program.document.save(own);
            QTRY_COMPARE_WITH_TIMEOUT(saved.size(), i + 2, kPatience);
        }
        const auto* settling = watch.findChild<QTimer*>();
        QSignalSpy looked(settling, &QTimer::timeout);
        QTRY_VERIFY_WITH_TIMEOUT(!looked.isEmpty() && !settling->isActive(), kPatience);
        QCOMPARE(changed.size(), 0);
        QFile again(QString::fromStdString(own));
        QVERIFY(again.open(QIODevice::Append));
        again.write(" ");
        again.close();
        QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kPatience);
        QCOMPARE(changed.size(), 1);
    }

    void anEditMeanwhileIsKept() {
        TouchedWindow program;
        const QString file = write(QStringLiteral("pot.obj"), potText(0.08));
        QVERIFY(program.open(file));
        QSignalSpy ended(&program.document, &Document::editEnded);
        program.document.updateGeometry(file.toStdString());
        setStiffness(program, 0, 321);
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
        COMPARE_CONTAINS(ended[0][0].toString(), "edited meanwhile");
        QCOMPARE(program.document.history().count(), 1);
    }

    void withoutASceneThereIsNothingToUpdate() {
        TouchedWindow program;
        QVERIFY(!program.command("update-geometry").isEnabled());
    }
};

TACTUM_GUI_TEST(TestUpdateGeometry)

} // namespace test_update_geometry

#include "test_update_geometry.moc"
