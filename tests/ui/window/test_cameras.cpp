// Cameras that are kept with the scene, as a person keeps, chooses and changes them.
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/style.h"
#include "ui/view/scene_view.h"

namespace test_cameras {

using namespace tactum;

class TestCameras : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static void keepAs(TouchedWindow& program, const QString& name) {
        answerTextDialog(name);
        program.command("camera-keep").trigger();
    }
    static QString withoutLetter(QString text) {
        text.replace(QStringLiteral("&&"), QStringLiteral("\t"));
        text.remove(u'&');
        return text.replace(u'\t', u'&');
    }
    /// Through the menu, by clicks.
    static void choose(TouchedWindow& program, std::initializer_list<const char*> path) {
        auto* menu =
            program.window->menuBar()->findChild<QMenu*>(QStringLiteral("View/&Camera/&Kept cameras"));
        menu->popup(program.window->mapToGlobal(QPoint(20, 20)));
        for (const char* words : path) {
            QAction* found = nullptr;
            for (QAction* action : menu->actions())
                if (withoutLetter(action->text().section(u'\t', 0, 0)) == QLatin1String(words))
                    found = action;
            if (!found || !found->isEnabled()) qFatal("there is no entry %s", words);
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(found).center());
            if (found->menu()) menu = found->menu();
        }
    }
    static const std::vector<SavedCamera>& cameras(TouchedWindow& program) {
        return program.document.scene().cameras;
    }
    /// Where two places of the model are in the view.
    static QPolygonF seen(TouchedWindow& program) {
        const ViewCamera& camera = program.window->view().camera();
        return {*camera.project({0.05, 0.05, 0.05}), *camera.project({-0.05, 0.02, -0.05})};
    }
    static double apart(const QPolygonF& a, const QPolygonF& b) {
        double most = 0;
        for (qsizetype i = 0; i < a.size(); ++i)
            most = std::max(most, std::hypot(a[i].x() - b[i].x(), a[i].y() - b[i].y()));
        return most;
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void aViewIsKeptAndComesBack();
    void keysLookFromThem();
    void eachEditIsOneStep();
    void oneNameIsOneCamera();
    void aNameThatIsTakenIsNotLost();
    void thePaletteHasWhatTheMenuHas();
    void theProjectionComesBack();
    void whatACameraBringsIsNoChoice();
    void theyAreInTheFile();
    void aClickOnAnAxisLooksAlongIt();
};

void TestCameras::aViewIsKeptAndComesBack() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    view.moveCamera(0.4, 0.2, 0.8);
    const QPolygonF before = seen(program);
    keepAs(program, QStringLiteral("corner & edge"));
    QCOMPARE(cameras(program).size(), std::size_t(1));
    view.showStandardView(StandardView::Top);
    QCOMPARE_GT(apart(seen(program), before), 5);
    choose(program, {"corner & edge"});
    QTRY_COMPARE_LT_WITH_TIMEOUT(apart(seen(program), before), 1e-3, kPatience);
    QVERIFY(program.document.history().canUndo()); // to look is no step, to keep is one
    QCOMPARE(program.document.history().count(), 1);
}

void TestCameras::keysLookFromThem() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    view.showStandardView(StandardView::Right);
    keepAs(program, QStringLiteral("side"));
    view.showStandardView(StandardView::Top);
    keepAs(program, QStringLiteral("top"));
    const QPolygonF top = seen(program);
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_1, Qt::AltModifier);
    QTRY_COMPARE_LT_WITH_TIMEOUT(std::abs(view.camera().yaw - EIGEN_PI / 2), 1e-9, kPatience);
    QTest::keyClick(&view, Qt::Key_2, Qt::AltModifier);
    QTRY_COMPARE_LT_WITH_TIMEOUT(apart(seen(program), top), 1e-3, kPatience);
    QTest::keyClick(&view, Qt::Key_9, Qt::AltModifier); // there is none
    QCOMPARE_LT(apart(seen(program), top), 1e-3);
}

void TestCameras::eachEditIsOneStep() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    QUndoStack& history = program.document.history();
    keepAs(program, QStringLiteral("first"));
    const Scene kept = program.document.scene();
    view.showStandardView(StandardView::Top);
    choose(program, {"Replace by this view", "first"});
    QVERIFY(cameras(program) != kept.cameras);
    QCOMPARE(history.count(), 2);
    answerTextDialog(QStringLiteral("second"));
    choose(program, {"Rename the camera", "first"});
    QTRY_COMPARE_WITH_TIMEOUT(cameras(program)[0].name, std::string("second"), kPatience);
    QCOMPARE(history.count(), 3);
    choose(program, {"Remove the camera", "second"});
    QVERIFY(cameras(program).empty());
    QCOMPARE(history.count(), 4);
    for (int i = 0; i < 3; ++i)
        program.command("undo").trigger();
    QVERIFY(program.document.scene() == kept);
    program.command("undo").trigger();
    QVERIFY(cameras(program).empty());
}

void TestCameras::oneNameIsOneCamera() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    keepAs(program, QStringLiteral("front"));
    const Scene before = program.document.scene();
    program.window->view().showStandardView(StandardView::Top);
    answerTakenName(QStringLiteral("front"), QStringLiteral("Replace by this view"), {});
    program.command("camera-keep").trigger();
    QVERIFY(program.document.scene() == before);
    keepAs(program, QString()); // thought better of
    QVERIFY(program.document.scene() == before);
}

void TestCameras::aNameThatIsTakenIsNotLost() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    keepAs(program, QStringLiteral("front"));
    keepAs(program, QStringLiteral("back"));
    answerTakenName(QStringLiteral("back"), QStringLiteral("There is a camera back already"),
                    QStringLiteral("front left"));
    choose(program, {"Rename the camera", "front"});
    QTRY_COMPARE_WITH_TIMEOUT(cameras(program)[0].name, std::string("front left"), kPatience);
    QCOMPARE(program.document.history().count(), 3);
    answerTextDialog(QStringLiteral("front left")); // its own: nothing is done, and nothing said
    choose(program, {"Rename the camera", "front left"});
    QCOMPARE(program.document.history().count(), 3);
}

void TestCameras::thePaletteHasWhatTheMenuHas() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    keepAs(program, QStringLiteral("front"));
    const auto run = [&](const QString& typed) {
        program.command("palette").trigger();
        auto* line = program.window->findChild<QLineEdit*>(QStringLiteral("palette-line"));
        QTest::keyClicks(line, typed);
        QTest::keyPress(line, Qt::Key_Return); // the palette may be gone when the key comes up
        QTRY_VERIFY_WITH_TIMEOUT(!program.window->findChild<QWidget*>(QStringLiteral("palette")), kPatience);
    };
    const SavedCamera before = cameras(program)[0];
    program.window->view().showStandardView(StandardView::Top);
    run(QStringLiteral("replace view front"));
    QTRY_VERIFY_WITH_TIMEOUT(!(cameras(program)[0].pose == before.pose), kPatience);
    answerTextDialog(QStringLiteral("above"));
    run(QStringLiteral("rename camera front"));
    QTRY_COMPARE_WITH_TIMEOUT(cameras(program)[0].name, std::string("above"), kPatience);
    run(QStringLiteral("remove camera above"));
    QTRY_VERIFY_WITH_TIMEOUT(cameras(program).empty(), kPatience);
}

void TestCameras::theProjectionComesBack() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.command("parallel").trigger();
    const QPolygonF before = seen(program);
    keepAs(program, QStringLiteral("plan"));
    program.command("parallel").trigger();
    program.window->view().showStandardView(StandardView::Top);
    choose(program, {"plan"});
    QVERIFY(program.command("parallel").isChecked());
    QTRY_COMPARE_LT_WITH_TIMEOUT(apart(seen(program), before), 1e-3, kPatience);
}

// A kept camera is drawn as it was kept; the next scene begins as the person likes it.
void TestCameras::whatACameraBringsIsNoChoice() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QAction& parallel = program.command("parallel");
    parallel.trigger();
    keepAs(program, QStringLiteral("plan"));
    parallel.trigger();
    choose(program, {"plan"});
    QVERIFY(program.window->view().camera().parallel);
    QVERIFY(!QSettings().value(QStringLiteral("view/parallel")).toBool());
    program.document.history().setClean();
    const QTemporaryDir other;
    QVERIFY(program.open(writeCube(other)));
    QVERIFY(!program.window->view().camera().parallel && !parallel.isChecked());
}

void TestCameras::theyAreInTheFile() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.window->view().moveCamera(0.3, -0.1);
    const QPolygonF before = seen(program);
    keepAs(program, QStringLiteral("mine"));
    const auto file = std::filesystem::path(folder_.filePath(QStringLiteral("kept.glb")).toStdString());
    program.document.save(file);
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.modified(), kPatience);
    QVERIFY(program.open(QString::fromStdString(file.string())));
    QCOMPARE(cameras(program).size(), std::size_t(1));
    program.window->view().showStandardView(StandardView::Top);
    choose(program, {"mine"});
    QTRY_COMPARE_LT_WITH_TIMEOUT(apart(seen(program), before), 1e-3, kPatience);
}

// Where an end of the cross is, the picture says. A click there is no click beside the model.
void TestCameras::aClickOnAnAxisLooksAlongIt() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.command("select").trigger();
    const SceneView& view = program.window->view();
    const auto ballOf = [&](const QColor& colour) {
        const QImage picture = program.window->grab(program.placeOf(view)).toImage();
        const qreal ratio = picture.devicePixelRatio();
        QPointF sum;
        int count = 0;
        for (int y = 0; y < int(160 * ratio); ++y)
            for (int x = picture.width() - int(100 * ratio); x < picture.width(); ++x)
                if (picture.pixelColor(x, y) == colour) {
                    sum += QPointF(x, y);
                    ++count;
                }
        return count == 0 ? QPoint() : (sum / (count * ratio)).toPoint();
    };
    const auto click = [&](QPoint at) {
        program.moveTo(at);
        program.press(at);
        program.release(at);
    };
    program.frames(5);
    const std::pair<QColor, Vec3> axes[] = {
        {theme().axisY, Vec3::UnitY()}, {theme().axisX, Vec3::UnitX()}, {theme().axisZ, Vec3::UnitZ()}};
    for (const auto& [colour, axis] : axes) {
        program.command("view-isometric").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(view.camera().forward().y() < -0.5, kPatience);
        program.frames(5);
        const auto selected = program.document.selected();
        QVERIFY(!selected.empty());
        const Vec3 focus = view.camera().focus;
        const double distance = view.camera().distance;
        const QPoint ball = ballOf(colour);
        QVERIFY(!ball.isNull());
        click(ball);
        QTRY_VERIFY_WITH_TIMEOUT((view.camera().forward() + axis).norm() < 1e-6, kPatience);
        COMPARE_NEAR((view.camera().focus - focus).norm(), 0, 1e-9, "m");
        COMPARE_NEAR(view.camera().distance, distance, 1e-9, "m");
        QVERIFY2(program.document.selected() == selected, "a click on the cross selects nothing");
    }
}

TACTUM_GUI_TEST(TestCameras)

} // namespace test_cameras

#include "test_cameras.moc"
