// Selecting in the view with real events: what a click and a box take, what grows from it, and what is done.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>

#include "core/scene/selection_sets.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_selecting {

using namespace tactum;

class TestSelecting : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static QAction& command(const TouchedWindow& program, const char* id) {
        for (const QMenu* menu : program.window->menuBar()->findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (action->objectName() == QLatin1String(id)) return *action;
        qFatal("there is no command %s", id);
    }
    static void click(TouchedWindow& program, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&program.window->view(), Qt::LeftButton, modifiers, program.centre());
    }
    static const std::vector<Index>& faces(const TouchedWindow& program) {
        return program.document.selectedFaces().faces;
    }
    /// Half of one side of the cube, whichever is in the middle of the view.
    static bool takeTriangle(TouchedWindow& program) {
        command(program, "take-triangle").trigger();
        click(program);
        return faces(program).size() == 1;
    }
    static void keepAs(TouchedWindow& program, const QString& name) {
        answerTextDialog(name);
        command(program, "set-keep").trigger();
    }
    /// Through the menu behind the button in the row, by clicks.
    static void chooseSet(TouchedWindow& program, std::initializer_list<const char*> path) {
        auto* button = program.window->findChild<QToolButton*>(QStringLiteral("sets-button"));
        QMenu* menu = button->menu();
        menu->popup(button->mapToGlobal(QPoint(0, button->height())));
        for (const char* words : path) {
            QAction* found = nullptr;
            for (QAction* action : menu->actions())
                if (withoutLetter(action->text()) == QLatin1String(words)) found = action;
            if (!found || !found->isEnabled()) qFatal("there is no entry %s", words);
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(found).center());
            if (found->menu()) menu = found->menu();
        }
    }
    /// "rim && &lid" as "rim & lid"
    static QString withoutLetter(QString text) {
        const QChar two(1);
        return text.replace(QStringLiteral("&&"), two).remove(u'&').replace(two, QStringLiteral("&"));
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void aClickTakesWhatTheRowSays_data();
    void aClickTakesWhatTheRowSays();
    void modifiersAddAndTakeBack();
    void ringsGrowAndShrink();
    void aBoxTakesWhatItTouches();
    void aLassoTakesWhatItGoesRound();
    void theBrushTakesWhatItGoesOver();
    void whatFacesTheSameWayNeedNotHangTogether();
    void coloursSelect();
    void theRowSaysHowMuch();
    void theRowHasRoomInASmallWindow();
    void theStatusSaysWhatTheMouseIsOver();
    void splitHideAndUndo();
    void theRowShowsWhatAClickTakes();
    void whatIsSelectedKeepsItsName();
    void aWholeSurfaceIsNoPart();
    void aSelectionIsKeptAsASet();
    void aSetIsChangedByItsMenu();
    void aSetOfSurfacesSelectsSurfaces();
    void thePaletteFindsSets();
};

void TestSelecting::aClickTakesWhatTheRowSays_data() {
    QTest::addColumn<QByteArray>("reach");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<int>("surfaces");
    QTest::newRow("surface") << QByteArray("take-surface") << 0 << 1;
    QTest::newRow("same feel") << QByteArray("take-material") << 0 << 6;
    QTest::newRow("same colour") << QByteArray("take-colour") << 0 << 1;
    QTest::newRow("connected") << QByteArray("take-connected") << 12 << 1;
    QTest::newRow("smooth") << QByteArray("take-smooth") << 2 << 1;
    QTest::newRow("similar") << QByteArray("take-similar") << 2 << 1;
    QTest::newRow("facing") << QByteArray("take-facing") << 2 << 1;
    QTest::newRow("triangle") << QByteArray("take-triangle") << 1 << 1;
}

void TestSelecting::aClickTakesWhatTheRowSays() {
    QFETCH(QByteArray, reach);
    QFETCH(int, triangles);
    QFETCH(int, surfaces);
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const Scene before = program.document.scene();
    program.document.select(std::nullopt);
    command(program, reach).trigger();
    QVERIFY(command(program, "select").isChecked());
    click(program);
    QTRY_COMPARE_WITH_TIMEOUT(int(faces(program).size()), triangles, kPatience);
    QCOMPARE(int(program.document.selected().size()), surfaces);
    const auto& surfaceOf = before.objects[0].geometry->surfaceOf;
    if (triangles == 2)
        for (const Index face : faces(program))
            QCOMPARE(surfaceOf[face], program.document.selection()->surface);
    QTest::mouseClick(&program.window->view(), Qt::LeftButton, {}, {8, 8}); // beside the model
    QVERIFY(faces(program).empty());
    QVERIFY(program.document.selected().empty());
    QVERIFY(program.document.scene() == before);
    QCOMPARE_EQ(program.document.history().count(), 0);
}

void TestSelecting::modifiersAddAndTakeBack() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(takeTriangle(program));
    const std::vector<Index> one = faces(program);
    command(program, "take-smooth").trigger();
    click(program, Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(2), kPatience);
    command(program, "take-triangle").trigger();
    click(program, Qt::ControlModifier);
    QCOMPARE(faces(program).size(), std::size_t(1));
    QVERIFY(faces(program) != one);
}

// A triangle of a cube has three neighbours, which have five more.
void TestSelecting::ringsGrowAndShrink() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(!command(program, "grow").isEnabled());
    QVERIFY(takeTriangle(program));
    const std::vector<Index> one = faces(program);
    command(program, "grow").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(4), kPatience);
    command(program, "shrink").trigger();
    QCOMPARE(faces(program), one);
    command(program, "invert").trigger();
    QCOMPARE(faces(program).size(), std::size_t(11));
}

void TestSelecting::aBoxTakesWhatItTouches() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    command(program, "take-triangle").trigger();
    const QSize size = program.window->view().size();
    const auto draw = [&](QPoint from, QPoint to) {
        command(program, "box").trigger();
        program.press(from);
        program.moveTo(to);
        program.release(to);
    };
    // From the lower left: over the upper one lies the tool's row.
    const QPoint begin(4, size.height() - 4);
    program.document.select(std::nullopt);
    draw(begin, {size.width() - 4, 4});
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(12), kPatience);
    // Triangles are enough to be kept, whether a surface is selected or not.
    keepAs(program, QStringLiteral("all"));
    QCOMPARE(setNames(program.document.scene()), std::vector<std::string>{"all"});
    draw(begin, begin + QPoint(8, -8));
    QTRY_VERIFY_WITH_TIMEOUT(faces(program).empty(), kPatience);
    command(program, "take-surface").trigger();
    draw(begin, {size.width() - 4, 4});
    QTRY_COMPARE_WITH_TIMEOUT(program.document.selected().size(), std::size_t(6), kPatience);
    // Three sides of a cube are seen at once; the others only through it.
    command(program, "through").trigger();
    draw(begin, {size.width() - 4, 4});
    QTRY_COMPARE_WITH_TIMEOUT(program.document.selected().size(), std::size_t(3), kPatience);
    command(program, "take-triangle").trigger();
    draw(begin, {size.width() - 4, 4});
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(6), kPatience);
}

/// A line round the whole model, then one round a place where the edges of the cube are not.
void TestSelecting::aLassoTakesWhatItGoesRound() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    command(program, "take-triangle").trigger();
    const QPoint middle = program.centre();
    const auto draw = [&](int radius, QPoint at) {
        QTest::keyClick(program.window.get(), Qt::Key_B, Qt::ShiftModifier);
        program.press(at + QPoint(radius, 0));
        for (int i = 1; i < 24; ++i) {
            const double angle = 2 * M_PI * i / 24;
            program.moveTo(at + QPoint(int(radius * std::cos(angle)), int(radius * std::sin(angle))));
        }
        program.release(at + QPoint(radius, 0));
    };
    draw(middle.y() - 10, middle);
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(12), kPatience);
    command(program, "through").trigger();
    draw(middle.y() - 10, middle);
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(6), kPatience);
    draw(6, middle + QPoint(30, 60));
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(1), kPatience);
    // Given up, it takes nothing.
    const std::vector<Index> one = faces(program);
    QTest::keyClick(program.window.get(), Qt::Key_B, Qt::ShiftModifier);
    program.press(middle);
    program.moveTo(middle + QPoint(40, 40));
    QTest::keyClick(&program.window->view(), Qt::Key_Escape);
    program.release(middle + QPoint(80, 0));
    QCOMPARE(faces(program), one);
    QCOMPARE_EQ(program.document.history().count(), 0);
}

void TestSelecting::theBrushTakesWhatItGoesOver() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    command(program, "take-triangle").trigger();
    QTest::keyClick(program.window.get(), Qt::Key_C);
    QVERIFY(command(program, "select-brush").isChecked());
    const QPoint middle = program.centre(), below = middle + QPoint(30, 60);
    const auto stroke = [&](QPoint from, QPoint to, Qt::KeyboardModifiers modifiers) {
        QTest::mousePress(program.window->windowHandle(), Qt::LeftButton, modifiers,
                          program.window->view().mapTo(program.window.get(), from));
        program.moveTo((from + to) / 2);
        program.moveTo(to);
    };
    for (int i = 0; i < 12; ++i)
        QTest::keyClick(program.window.get(), Qt::Key_BracketLeft);
    const auto colourBelow = [&] { // beside the ring
        SceneView& view = program.window->view();
        return view.grabPicture().pixelColor((below + QPoint(12, 0)) * view.devicePixelRatioF());
    };
    program.moveTo(below); // what is under the mouse is lit
    program.frames(5);
    const QColor before = colourBelow();
    stroke(below, below + QPoint(2, 2), {});
    // It is shown while the button is still down, and selected at the end.
    QTRY_VERIFY_WITH_TIMEOUT(colourBelow() != before, kPatience);
    QVERIFY(faces(program).empty());
    program.release(below);
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(1), kPatience);
    const std::vector<Index> one = faces(program);
    // Given up, nothing of it is left; else what it went over comes to it.
    const auto more = [&](bool givenUp) {
        stroke(middle + QPoint(0, 60), middle - QPoint(60, 60), Qt::ShiftModifier);
        if (givenUp) QTest::keyClick(&program.window->view(), Qt::Key_Escape);
        program.release(middle - QPoint(60, 60));
    };
    more(true);
    program.frames(2);
    QCOMPARE(faces(program), one);
    more(false);
    QTRY_COMPARE_GE_WITH_TIMEOUT(faces(program).size(), std::size_t(2), kPatience);
    QCOMPARE_LE(faces(program).size(), std::size_t(6)); // no side that is not seen
    // A larger brush takes more at once, and Ctrl takes it back.
    for (int i = 0; i < 30; ++i)
        QTest::keyClick(program.window.get(), Qt::Key_BracketRight);
    stroke(middle, middle, {});
    program.release(middle);
    QTRY_COMPARE_GE_WITH_TIMEOUT(faces(program).size(), std::size_t(5), kPatience);
    stroke(middle, middle, Qt::ControlModifier);
    program.release(middle);
    QTRY_VERIFY_WITH_TIMEOUT(faces(program).empty(), kPatience);
    // Beside the model it takes nothing, and surfaces where a click takes surfaces.
    command(program, "take-surface").trigger();
    stroke(middle, middle, {});
    program.release(middle);
    QTRY_COMPARE_WITH_TIMEOUT(program.document.selected().size(), std::size_t(3), kPatience);
    QTest::keyClick(&program.window->view(), Qt::Key_Escape);
    QVERIFY(!command(program, "select-brush").isChecked());
    QVERIFY(command(program, "select").isChecked());
}

/// Two steps of a stair: two treads that look up, apart from each other.
void TestSelecting::whatFacesTheSameWayNeedNotHangTogether() {
    const QString stair =
        writeFile(folder_, QStringLiteral("stair.obj"),
                  "v 0 0 0\nv .1 0 0\nv .1 0 .1\nv 0 0 .1\nv .1 .1 0\nv .1 .1 .1\nv .2 .1 0\nv .2 .1 .1\n"
                  "f 1 4 3 2\nf 2 3 6 5\nf 5 6 8 7\n");
    TouchedWindow program;
    QVERIFY(program.open(stair));
    program.window->view().showStandardView(StandardView::Top);
    const auto place = [&](const Vec3& p) { return program.window->view().camera().project(p)->toPoint(); };
    const SceneObject& object = program.document.scene().objects[0];
    Vec3 tread = Vec3::Zero();
    for (const Index corner : object.geometry->triangles[0])
        tread += object.pose.apply(object.geometry->positions[corner]) / 3;
    const auto takes = [&](const char* reach, std::size_t triangles) {
        command(program, reach).trigger();
        QTest::mouseClick(&program.window->view(), Qt::LeftButton, {}, place(tread));
        return test::waitFor([&] { return faces(program).size() == triangles; });
    };
    QVERIFY(takes("take-similar", 2));
    QVERIFY(takes("take-facing", 4));
    QCOMPARE(faces(program), (std::vector<Index>{0, 1, 4, 5}));
}

void TestSelecting::coloursSelect() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const ObjectId cube = program.document.scene().objects[0].id;
    program.document.editScene(QStringLiteral("Colour"), SceneChange::What::Objects, [](Scene& scene) {
        for (const Index i : {1, 4})
            scene.objects[0].surfaces[i].colour = {0.9F, 0.1F, 0.1F};
    });
    program.document.select(SurfaceRef{cube, 4});
    QTest::keyClick(program.window.get(), Qt::Key_C, Qt::ShiftModifier);
    QCOMPARE(program.document.selected(), (SurfaceRefs{{cube, 1}, {cube, 4}}));
}

void TestSelecting::theRowSaysHowMuch() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    command(program, "select").trigger();
    auto* count = program.window->findChild<QLabel*>(QStringLiteral("selection-count"));
    QVERIFY(count && count->isVisible());
    const auto says = [&](const char* text) {
        const QString expected = QString::fromUtf8(text);
        return test::waitFor([&] { return count->text() == expected; });
    };
    const ObjectId cube = program.document.scene().objects[0].id;
    program.document.select({SurfaceRef{cube, 0}, SurfaceRef{cube, 1}});
    QVERIFY2(says("4 triangles, 200 cm\u00b2"), qPrintable(count->text()));
    QVERIFY(takeTriangle(program));
    QVERIFY2(says("1 triangle, 50.0 cm\u00b2"), qPrintable(count->text()));
    command(program, "invert").trigger();
    QVERIFY2(says("11 triangles, 550 cm\u00b2"), qPrintable(count->text()));
    command(program, "select-none").trigger();
    QVERIFY2(says(""), qPrintable(count->text()));
}

// It was cut off at its right end: Grow and Shrink could not be seen in a window of 1280 x 800.
void TestSelecting::theRowHasRoomInASmallWindow() {
    TouchedWindow program;
    program.window->resize(1280, 800);
    QVERIFY(program.open(writeCube(folder_)));
    command(program, "select").trigger();
    command(program, "select-all").trigger();
    const auto* strip = program.window->findChild<QWidget*>(QStringLiteral("tool-strip"));
    QTRY_COMPARE(strip->isVisible(), true);
    for (const auto* button : strip->findChildren<QToolButton*>()) {
        if (!button->isVisible()) continue;
        const int right = button->mapTo(strip, QPoint(button->width(), 0)).x();
        QVERIFY2(right <= strip->width(), qPrintable(button->text()));
    }
}

void TestSelecting::theStatusSaysWhatTheMouseIsOver() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const auto* note = program.window->findChild<QLabel*>(QStringLiteral("status-note"));
    program.moveTo({8, program.window->view().height() - 8});
    program.moveTo(program.centre());
    const SurfaceRef there = *program.window->view().surfaceAt(program.centre());
    const QString name = QString::fromStdString(program.document.surface(there)->name);
    const QString feel = name + QStringLiteral(": 800 N/m, friction 0.00 / 0.00");
    QTRY_COMPARE_WITH_TIMEOUT(note->toolTip(), feel, kPatience);
    program.document.setMaterialValue(there, kMaterialFields[0], 650);
    QTRY_COMPARE_WITH_TIMEOUT(note->toolTip(),
                              QString(feel).replace(QStringLiteral("800"), QStringLiteral("650")), kPatience);
    program.moveTo({8, program.window->view().height() - 8});
    QTRY_VERIFY_WITH_TIMEOUT(!note->toolTip().contains(name), kPatience);
    // What is touched has its own words.
    program.press(program.centre());
    QVERIFY(test::waitFor([&] { return program.touch().contacts > 0; }));
    program.frames(2);
    QVERIFY(!note->toolTip().contains(name));
    program.release(program.centre());
}

void TestSelecting::splitHideAndUndo() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const Scene before = program.document.scene();
    QVERIFY(takeTriangle(program));
    const auto shownHere = program.document.selectedFaces();
    QTest::keyClick(program.window.get(), Qt::Key_Y);
    QTRY_COMPARE_WITH_TIMEOUT(program.document.scene().objects[0].surfaces.size(), std::size_t(7), kPatience);
    QVERIFY(faces(program).empty());
    QTest::keyClick(program.window.get(), Qt::Key_H);
    QVERIFY(!program.document.surface({shownHere.object, 6})->visible);
    // What is hidden lets a click through to what lies behind it.
    command(program, "take-surface").trigger();
    click(program);
    QVERIFY(program.document.selection().has_value());
    QCOMPARE_NE(program.document.selection()->surface, 6);
    while (program.document.history().canUndo())
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(program.document.scene() == before);
}

void TestSelecting::theRowShowsWhatAClickTakes() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* row = program.window->findChild<QWidget*>(QStringLiteral("tool-strip"));
    QVERIFY(!row->isVisible());
    QTest::keyClick(program.window.get(), Qt::Key_Q);
    QVERIFY(row->isVisible());
    program.frames(5);
    const QRect there(row->mapTo(program.window.get(), QPoint(0, 0)), row->size());
    const QWidget* seen = program.window->childAt(there.center());
    QVERIFY2(seen == row || row->isAncestorOf(seen), "the view hides it");
    auto* list = row->findChild<QComboBox*>();
    QCOMPARE(list->currentText(), QStringLiteral("Surface"));
    command(program, "take-smooth").trigger();
    QCOMPARE(list->currentText(), QStringLiteral("Smooth part"));
    QTest::keyClick(list, Qt::Key_End); // letters are commands of the window
    QVERIFY(command(program, "take-triangle").isChecked());
}

// Surfaces get other numbers when triangles go to others.
void TestSelecting::whatIsSelectedKeepsItsName() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const ObjectId cube = program.document.scene().objects[0].id;
    const auto names = [&] {
        std::string all;
        for (const SurfaceRef ref : program.document.selected())
            all += program.document.surface(ref)->name + " ";
        return all;
    };
    program.document.select({SurfaceRef{cube, 0}, SurfaceRef{cube, 1}});
    program.document.mergeSelected(); // right and left: all others move down
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.editing(), kPatience);
    program.document.select(SurfaceRef{cube, 4}); // back
    QCOMPARE(names(), std::string("back "));
    program.document.history().undo();
    QCOMPARE(names(), std::string("back "));
    program.document.history().redo();
    QCOMPARE(names(), std::string("back "));
    // What was split off goes with the step, and comes back with it.
    QVERIFY(takeTriangle(program));
    program.document.splitSelection();
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.editing(), kPatience);
    const std::string part = names();
    program.document.history().undo();
    QVERIFY(program.document.selected().empty());
    program.document.history().redo();
    QCOMPARE(names(), part);
}

void TestSelecting::aWholeSurfaceIsNoPart() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const Scene before = program.document.scene();
    program.document.selectFaces({before.objects[0].id, {0, 1}}); // the right side
    program.document.splitSelection();
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.editing(), kPatience);
    QVERIFY(program.document.scene() == before);
    QCOMPARE_EQ(program.document.history().count(), 0);
}

/// Triangles, over a split, undo and a file.
void TestSelecting::aSelectionIsKeptAsASet() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(takeTriangle(program));
    command(program, "grow").trigger();
    QTRY_COMPARE_WITH_TIMEOUT(faces(program).size(), std::size_t(4), kPatience);
    const std::vector<Index> kept = faces(program);
    const Scene before = program.document.scene();
    keepAs(program, QStringLiteral("rim & lid"));
    QCOMPARE(setNames(program.document.scene()), std::vector<std::string>{"rim & lid"});
    program.document.history().undo();
    QVERIFY2(program.document.scene() == before, "one step");
    program.document.history().redo();
    command(program, "select-none").trigger();
    chooseSet(program, {"rim & lid"});
    QCOMPARE(faces(program), kept);
    program.document.splitSelection();
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.editing(), kPatience);
    const QString file = folder_.filePath(QStringLiteral("kept.glb"));
    program.document.save(std::filesystem::path(file.toStdU16String()));
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.saving(), kPatience);
    QVERIFY(program.open(file));
    command(program, "select-none").trigger();
    chooseSet(program, {"rim & lid"});
    QCOMPARE(program.document.selected().size(), 1u); // of the new surface it is the whole
    QCOMPARE(program.document.selectedTriangles().begin()->second, kept);
}

void TestSelecting::aSetIsChangedByItsMenu() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const ObjectId cube = program.document.scene().objects[0].id;
    const auto rim = [&](const char* name) {
        const SceneTriangles set = trianglesOfSet(program.document.scene(), name);
        return set.empty() ? TriangleSet() : set.at(cube);
    };
    command(program, "select").trigger();
    program.document.select(SurfaceRef{cube, 0});
    program.document.selectFaces({cube, {1, 4}});
    keepAs(program, QStringLiteral("rim"));
    program.document.selectFaces({cube, {7}});
    chooseSet(program, {"Add the selection to", "rim"});
    QCOMPARE(rim("rim"), (TriangleSet{1, 4, 7}));
    chooseSet(program, {"Replace by the selection", "rim"});
    QCOMPARE(rim("rim"), TriangleSet{7});
    answerTextDialog(QStringLiteral("edge"));
    chooseSet(program, {"Rename the set", "rim"});
    QCOMPARE(rim("edge"), TriangleSet{7});
    answerTakenName(QStringLiteral("edge"), QStringLiteral("There is a set edge already"), {});
    command(program, "set-keep").trigger();
    chooseSet(program, {"Remove the set", "edge"});
    QCOMPARE(setNames(program.document.scene()), std::vector<std::string>());
    QCOMPARE(program.document.history().count(), 5);
}

void TestSelecting::aSetOfSurfacesSelectsSurfaces() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const ObjectId cube = program.document.scene().objects[0].id;
    program.document.duplicate({cube});
    const ObjectId copy = program.document.scene().objects[1].id;
    command(program, "select").trigger();
    const SurfaceRefs both{SurfaceRef{cube, 2}, SurfaceRef{copy, 3}};
    program.document.select(both);
    keepAs(program, QStringLiteral("two sides"));
    command(program, "select-none").trigger();
    chooseSet(program, {"two sides"});
    QVERIFY2(program.document.selected() == both, "the surfaces that were kept");
    QVERIFY2(program.document.selectedFaces().empty(), "and no triangles");
    // Parts of surfaces on two objects: those of the active one, and a line.
    program.document.select(SurfaceRef{copy, 0});
    program.document.selectFaces({copy, {0}});
    chooseSet(program, {"Add the selection to", "two sides"});
    chooseSet(program, {"two sides"});
    QCOMPARE(program.document.selectedFaces().object, copy);
    QCOMPARE(faces(program).size(), 3u);
    const auto* notice = program.window->findChild<NoticeBar*>();
    QVERIFY2(notice->text().contains(QStringLiteral("on 2 objects")), qPrintable(notice->text()));
}

void TestSelecting::thePaletteFindsSets() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(takeTriangle(program));
    const std::vector<Index> kept = faces(program);
    keepAs(program, QStringLiteral("rim"));
    command(program, "select-none").trigger();
    command(program, "palette").trigger();
    auto* line = program.window->findChild<QLineEdit*>(QStringLiteral("palette-line"));
    QVERIFY2(line, "the palette is open");
    QTest::keyClicks(line, QStringLiteral("select set rim"));
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(faces(program), kept, kPatience);
}

TACTUM_GUI_TEST(TestSelecting)

} // namespace test_selecting

#include "test_selecting.moc"
