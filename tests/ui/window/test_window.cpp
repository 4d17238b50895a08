// The window around the touch: panels, files that are dropped, what is remembered, numbers in any locale.
#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSlider>
#include <QStackedWidget>
#include <QTabBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/numbers.h"
#include "ui/base/shortcuts.h"
#include "ui/base/style.h"
#include "ui/document/recent_files.h"
#include "ui/panels/history_list.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"

namespace test_window {

using namespace tactum;

class TestWindow : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static const Material& materialOf(const TouchedWindow& program, Index surface) {
        return program.document.scene().objects.front().surfaces[surface].material;
    }
    static QString noticeOf(const TouchedWindow& program) {
        const auto* label = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
        return label->isVisible() ? label->text() : QString();
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void aWindowAtRestIsNotDrawn();
    void aWindowIsDressedOnce();
    void aDroppedModelIsOpened();
    void aBrokenFileIsOneLineAndNoHarm();
    void aSceneThatCannotBeFeltSaysWhy();
    void aNoticeMovesNothing();
    void aNoticeMovesNoRowOfATool();
    void theAxesAreSeenBelowANotice();
    void theRowOfAToolMovesNothing();
    void selectionGoesBothWays();
    void aSelectedRowKeepsItsColour();
    void problemsGoWithTheirObject();
    void theEyeHidesWhatIsFelt();
    void theInspectorIsMadeFromTheTable();
    void theInspectorShadesASurface();
    void theInspectorChoosesTheSides();
    void aSliderDragIsOneStep();
    void ctrlZInAFieldUndoesTheLastEdit();
    void numbersHaveAPointInEveryLocale();
    void layoutAndRecentFilesAreRemembered();
    void tabHidesThePanelsOfTheView();
    void tabTwiceLeavesTheTitlesAsTheyAre();
    void aboutSaysWhichVersionItIs();
    void everyKeyIsGivenOnce();
    void keysTurnTheCamera();
    void undoneStepsAreDim();
};

/// Each widget that draws itself has all of the window put together anew. The rates are told twice a second,
/// and nothing else changes while plots are folded and nobody moves. One telling draws up to three times: the
/// rates, a note when the loops are late, and the layout that follows from both.
void TestWindow::aWindowAtRestIsNotDrawn() {
    struct Drawn : QObject {
        bool eventFilter(QObject*, QEvent* event) override {
            times += event->type() == QEvent::UpdateRequest;
            layouts += event->type() == QEvent::LayoutRequest;
            return false;
        }
        int times = 0, layouts = 0;
    } window, bars;
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(test::waitFor([&] { return program.window->view().rests(); }));
    program.frames(60);
    program.window->installEventFilter(&window);
    for (auto* bar : program.window->findChildren<QTabBar*>())
        bar->installEventFilter(&bars);
    QElapsedTimer clock;
    clock.start();
    program.frames(120);
    constexpr int kPerTelling = 3, kTellingMs = 500;
    QCOMPARE_LE(window.times, kPerTelling * (2 + clock.elapsed() / kTellingMs)); // of a hundred pictures
    QCOMPARE_LE(bars.layouts, 2);
}

/// A style sheet is looked up anew for all that is in a widget when the widget is put into another one: a
/// third of what a window's making takes where it is not kept away meanwhile.
void TestWindow::aWindowIsDressedOnce() {
    struct Dressed : QObject {
        bool eventFilter(QObject* watched, QEvent* event) override {
            times += event->type() == QEvent::StyleChange && watched->isWidgetType();
            return false;
        }
        int times = 0;
    } dressed;
    qApp->installEventFilter(&dressed);
    const TouchedWindow program;
    qApp->removeEventFilter(&dressed);
    const auto widgets = program.window->findChildren<QWidget*>().size();
    QCOMPARE_GT(widgets, 1000);
    QCOMPARE_LE(dressed.times, 2 * widgets);
}

void TestWindow::aDroppedModelIsOpened() {
    TouchedWindow program;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(writeCube(folder_))});
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(program.window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(program.window.get(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp(), kPatience);
    QCOMPARE(program.document.scene().objects.size(), std::size_t(1));
    QVERIFY(program.window->view().isVisible());
    COMPARE_BEGINS(program.window->windowTitle(), QStringLiteral("cube.obj"));
}

void TestWindow::aBrokenFileIsOneLineAndNoHarm() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.window->open(writeFile(folder_, QStringLiteral("torn.ply"), "ply\nformat"));
    QTRY_VERIFY_WITH_TIMEOUT(noticeOf(program).contains(QStringLiteral("torn.ply")), kPatience);
    QVERIFY(!noticeOf(program).contains(u'\n'));
    QCOMPARE(program.document.scene().objects[0].surfaces.size(), std::size_t(6));
    COMPARE_BEGINS(program.window->windowTitle(), QStringLiteral("cube.obj"));
}

/// More loose bodies than forces can move.
void TestWindow::aSceneThatCannotBeFeltSaysWhy() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Scene scene = program.document.scene();
    for (BodyId id = 1; id <= 1000; ++id) {
        RigidBody body;
        body.id = id;
        scene.mechanics.bodies.push_back(body);
    }
    program.document.replaceScene(QStringLiteral("Many bodies"), scene);
    QTRY_VERIFY_WITH_TIMEOUT(noticeOf(program).contains(QStringLiteral("make some of them still")),
                             kPatience);
    QVERIFY(!noticeOf(program).contains(u'\n'));
}

// It comes by itself, perhaps while somebody presses on the model.
void TestWindow::aNoticeMovesNothing() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const SceneView& view = program.window->view();
    const QRect before = program.placeOf(view);
    program.window->showFault(QStringLiteral("The disk is full; make room and save again."));
    program.frames(5);
    QCOMPARE(program.placeOf(view), before);
    const auto* notice = program.window->findChild<QWidget*>(QStringLiteral("notice"));
    QCOMPARE(notice->mapTo(program.window.get(), QPoint(0, 0)), before.topLeft());
    QCOMPARE(notice->width(), before.width());
    QVERIFY2(notice->height() < before.height() / 4, "it is one line, not a curtain");
    const QWidget* seen = program.window->childAt(before.topLeft() + QPoint(before.width() / 2, 8));
    QVERIFY2(seen == notice || notice->isAncestorOf(seen), "the view hides it");
}

/// Its three lettered ends, each in the colour of its axis, are drawn where nothing lies over the view.
// What comes by itself must not take a button away from under the pointer.
void TestWindow::aNoticeMovesNoRowOfATool() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto& notice = *program.window->findChild<NoticeBar*>();
    notice.hide();
    program.command("select").trigger();
    program.frames(2);
    ToolStrip* strip = nullptr;
    for (ToolStrip* each : program.window->findChildren<ToolStrip*>())
        if (each->isVisible()) strip = each;
    QVERIFY(strip);
    const QRect before = program.placeOf(*strip);
    notice.showNote(QStringLiteral("said over the view"));
    program.frames(2);
    QVERIFY(notice.isVisible());
    QCOMPARE(program.placeOf(*strip), before);
    QCOMPARE_GE(program.placeOf(notice).top(), before.bottom());
}

void TestWindow::theAxesAreSeenBelowANotice() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const SceneView& view = program.window->view();
    const auto seenFrom = [&] { // the uppermost row of the corner with a colour of the axes
        const QImage picture = program.window->grab(program.placeOf(view)).toImage();
        const qreal ratio = picture.devicePixelRatio();
        for (int y = 0; y < int(200 * ratio); ++y)
            for (int x = picture.width() - int(100 * ratio); x < picture.width(); ++x)
                if (picture.pixelColor(x, y) == theme().axisY) return int(y / ratio);
        return -1;
    };
    program.frames(5);
    const int before = seenFrom();
    QCOMPARE_GE(before, 0);
    program.window->showFault(QStringLiteral("The disk is full; make room and save again."));
    program.frames(5);
    const auto* notice = program.window->findChild<QWidget*>(QStringLiteral("notice"));
    QCOMPARE_GE(seenFrom(), notice->height());
    QTRY_COMPARE_WITH_TIMEOUT(seenFrom(), before + notice->height(), kPatience); // as a whole
    notice->findChild<QToolButton*>()->click();                                  // closes it
    QTRY_COMPARE_WITH_TIMEOUT(seenFrom(), before, kPatience);
}

// The pointer is over the model when a key chooses the tool.
void TestWindow::theRowOfAToolMovesNothing() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const SceneView& view = program.window->view();
    const QRect before = program.placeOf(view);
    for (const auto& [key, name] :
         {std::pair(Qt::Key_Q, "tool-strip"), {Qt::Key_M, "arrange-strip"}, {Qt::Key_P, "paint-strip"}}) {
        QTest::keyClick(program.window.get(), key);
        program.frames(5);
        const auto* row = program.window->findChild<QWidget*>(QLatin1String(name));
        QVERIFY(row->isVisible());
        QCOMPARE(program.placeOf(view), before);
        const QRect covered = program.placeOf(*row);
        QVERIFY(before.contains(covered));
        QVERIFY2(covered.height() < before.height() / 4, "it is one line, not a curtain");
        const QWidget* seen = program.window->childAt(covered.center());
        QVERIFY2(seen == row || row->isAncestorOf(seen), "the view hides it");
    }
}

void TestWindow::selectionGoesBothWays() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.window->view().showStandardView(StandardView::Front);
    program.frames(10);
    auto* outliner = program.window->findChild<QTreeWidget*>(QStringLiteral("outliner"));
    outliner->setCurrentItem(outliner->topLevelItem(0)->child(2));
    QCOMPARE(program.document.selection()->surface, Index(2));
    // A click in the view: the front side, with the tool that touches nothing.
    QTest::keyClick(program.window.get(), Qt::Key_Q);
    program.press(program.centre());
    program.release(program.centre());
    QTRY_COMPARE_WITH_TIMEOUT(program.document.selection()->surface, Index(4), kPatience);
    QCOMPARE(outliner->currentItem()->text(0), QStringLiteral("front"));
}

void TestWindow::aSelectedRowKeepsItsColour() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* outliner = program.window->findChild<QTreeWidget*>(QStringLiteral("outliner"));
    const QIcon icon = outliner->topLevelItem(0)->child(2)->icon(0);
    QVERIFY(!icon.isNull());
    const auto colour = [&](QIcon::Mode mode) {
        return icon.pixmap(QSize(16, 16), mode).toImage().pixelColor(QPoint(8, 8)).rgb();
    };
    for (const QIcon::Mode mode : {QIcon::Selected, QIcon::Disabled})
        QCOMPARE(colour(mode), colour(QIcon::Normal));
}

void TestWindow::problemsGoWithTheirObject() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* problems = program.window->findChild<QTreeWidget*>(QStringLiteral("problems"));
    const auto listed = [&] {
        QStringList lines;
        for (int i = 0; i < problems->topLevelItemCount(); ++i)
            lines << problems->topLevelItem(i)->text(0);
        return lines.join(u'\n');
    };
    QTRY_VERIFY_WITH_TIMEOUT(listed().contains(QStringLiteral("cube: ")), kPatience);
    program.document.removeObject(program.document.scene().objects.front().id);
    QTRY_VERIFY_WITH_TIMEOUT(!listed().contains(QStringLiteral("cube: ")), kPatience);
    program.document.history().undo();
    QTRY_VERIFY_WITH_TIMEOUT(listed().contains(QStringLiteral("cube: ")), kPatience);
}

void TestWindow::theEyeHidesWhatIsFelt() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const auto sides = [&] { return program.window->publisher().world()->bodies.at(0).sides; };
    QVERIFY(sides().empty()); // all are felt from both
    QTest::keyClick(program.window.get(), Qt::Key_H);
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp() && !sides().empty(), kPatience);
    QCOMPARE(std::ranges::count(sides(), Sides::None), 1); // the selected surface
    QTest::keyClick(program.window.get(), Qt::Key_H, Qt::AltModifier);
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp() && sides().empty(), kPatience);
}

void TestWindow::theInspectorIsMadeFromTheTable() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    for (const MaterialField& field : kMaterialFields) {
        const QString key =
            QString::fromUtf8(field.parameter->key.data(), qsizetype(field.parameter->key.size()));
        QDoubleSpinBox& box = program.box(key);
        QCOMPARE(box.minimum(), field.parameter->minimum);
        QCOMPARE(box.maximum(), field.parameter->maximum);
        QVERIFY(!box.accessibleName().isEmpty());
        COMPARE_CONTAINS(box.parentWidget()->toolTip(), QString::fromUtf8(field.parameter->label.data()));
        program.type(key, numberText(0.5 * field.parameter->maximum, field.parameter->decimals));
        QCOMPARE(materialOf(program, 0).*field.value, 0.5 * field.parameter->maximum);
        QTest::mouseClick(program.window->findChild<QWidget*>(key + QStringLiteral("-reset")),
                          Qt::LeftButton);
        QCOMPARE(materialOf(program, 0).*field.value, field.parameter->initial);
    }
    // Out of range: brought into it, and shown so.
    program.type(QStringLiteral("static-friction"), QStringLiteral("99"));
    QCOMPARE(materialOf(program, 0).staticFriction, kStaticFriction.maximum);
    QCOMPARE(program.box(QStringLiteral("static-friction")).text(), QStringLiteral("2.000"));
    const auto* hint = program.window->findChild<QLabel*>(QStringLiteral("static-friction-hint"));
    QVERIFY(hint->isVisible());
    QCOMPARE(hint->text().trimmed(), QStringLiteral("At most 2.000"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.5"));
    QVERIFY(!hint->isVisible());
    // Metres are millimetres on the screen.
    program.type(QStringLiteral("proxy-radius"), QStringLiteral("2.5 mm"));
    COMPARE_NEAR(program.document.scene().proxyRadius, 0.0025, 1e-12, "m");
}

void TestWindow::theInspectorShadesASurface() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const auto shading = [&] { return program.document.scene().objects.front().surfaces[0].shading; };
    const auto feltBodies = [&] {
        return !program.window->publisher().world()->bodies.front().feels.empty();
    };
    auto* box = program.window->findChild<QCheckBox*>(QStringLiteral("force-shading"));
    QVERIFY(box);
    QVERIFY(!box->isChecked());
    QVERIFY(!feltBodies());
    QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, {8, box->height() / 2});
    QVERIFY(shading().on);
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp() && feltBodies(), kPatience);
    // Radians are degrees on the screen.
    program.type(QStringLiteral("crease-angle"), QStringLiteral("90"));
    COMPARE_NEAR(shading().creaseAngle, 0.5 * std::numbers::pi, 1e-9, "rad");
    program.document.history().undo();
    program.document.history().undo();
    QVERIFY(shading() == Shading{});
    QVERIFY(!box->isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp() && !feltBodies(), kPatience);
}

void TestWindow::theInspectorChoosesTheSides() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const auto button = [&](const char* name) {
        return program.window->findChild<QToolButton*>(QString::fromLatin1(name));
    };
    const auto felt = [&] { return program.window->publisher().world()->bodies.front().sides; };
    QVERIFY(button("sides-both")->isChecked());
    QVERIFY(felt().empty());
    QTest::mouseClick(button("sides-front"), Qt::LeftButton);
    QCOMPARE(program.document.scene().objects.front().surfaces[0].sides, Sides::Front);
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp() && felt().size() == 6, kPatience);
    QCOMPARE(felt()[0], Sides::Front);
    // Another surface has its own.
    program.document.select(SurfaceRef{program.document.scene().objects.front().id, 3});
    QVERIFY(button("sides-both")->isChecked());
    QVERIFY(!button("sides-front")->isChecked());
    program.document.history().undo();
    program.document.select(SurfaceRef{program.document.scene().objects.front().id, 0});
    QVERIFY(button("sides-both")->isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp() && felt().empty(), kPatience);
}

void TestWindow::aSliderDragIsOneStep() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* slider = program.window->findChild<QSlider*>(QStringLiteral("static-friction-slider"));
    const int y = slider->height() / 2;
    QTest::mousePress(slider, Qt::LeftButton, {}, {20, y});
    for (int x = 30; x <= 100; x += 10) {
        QMouseEvent move(QEvent::MouseMove, QPointF(x, y), slider->mapToGlobal(QPointF(x, y)), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(slider, &move);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {100, y});
    QVERIFY(!slider->isSliderDown()); // or it would not follow the undo
    QCOMPARE_GT(materialOf(program, 0).staticFriction, 0.3);
    QCOMPARE(program.document.history().count(), 1);
    QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(materialOf(program, 0).staticFriction, kStaticFriction.initial);
}

void TestWindow::ctrlZInAFieldUndoesTheLastEdit() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("viscosity"), QStringLiteral("5"));
    QCOMPARE(materialOf(program, 0).viscosity, 5.0);
    QTest::keyClick(&program.box(QStringLiteral("viscosity")), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(materialOf(program, 0).viscosity, 0.0);
    QTest::keyClick(&program.box(QStringLiteral("viscosity")), Qt::Key_Z,
                    Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(materialOf(program, 0).viscosity, 5.0);
}

void TestWindow::numbersHaveAPointInEveryLocale() {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0,35"));
    QCOMPARE(materialOf(program, 0).staticFriction, 0.35);
    QCOMPARE(program.box(QStringLiteral("static-friction")).text(), QStringLiteral("0.350"));
    program.type(QStringLiteral("stiffness"), QStringLiteral("1250"));
    QCOMPARE(program.box(QStringLiteral("stiffness")).text(), QStringLiteral("1250"));
    for (const auto* label : program.window->findChildren<QLabel*>())
        QVERIFY2(!label->text().contains(QRegularExpression(QStringLiteral("\\d,\\d"))),
                 qPrintable(label->text()));
}

void TestWindow::layoutAndRecentFilesAreRemembered() {
    const QString cube = writeCube(folder_);
    {
        TouchedWindow program;
        QVERIFY(program.open(cube));
        program.window->findChild<QDockWidget*>(QStringLiteral("dock-history"))->hide();
        program.window->resize(1000, 700);
        program.window->close();
    }
    QCOMPARE(recentFiles().value(0), cube);
    TouchedWindow again({1200, 800});
    QVERIFY(again.open(cube));
    QVERIFY(!again.window->findChild<QDockWidget*>(QStringLiteral("dock-history"))->isVisible());
    QVERIFY(again.window->findChild<QDockWidget*>(QStringLiteral("dock-inspector"))->isVisible());
    forgetRecentFiles();
    QVERIFY(recentFiles().isEmpty());
}

void TestWindow::tabHidesThePanelsOfTheView() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* dock = program.window->findChild<QDockWidget*>(QStringLiteral("dock-inspector"));
    QVERIFY(dock->isVisible());
    program.window->activateWindow();
    program.window->view().setFocus();
    QTest::keyClick(&program.window->view(), Qt::Key_Tab);
    QVERIFY(!dock->isVisible());
    QTest::keyClick(&program.window->view(), Qt::Key_Tab);
    QVERIFY(dock->isVisible());
}

/// A dock among tabs has its title there.
void TestWindow::tabTwiceLeavesTheTitlesAsTheyAre() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const auto titled = [&] {
        QStringList names;
        for (const auto* dock : program.window->findChildren<QDockWidget*>())
            if (!dock->titleBarWidget()) names << dock->objectName();
        names.sort();
        return names;
    };
    const QStringList before = titled();
    QVERIFY(!before.contains(QStringLiteral("dock-inspector")));
    program.window->view().setFocus();
    for (int i = 0; i < 4; ++i) {
        QTest::keyClick(&program.window->view(), Qt::Key_Tab);
        program.frames(5);
        if (i % 2 == 1) QCOMPARE(titled(), before);
    }
}

void TestWindow::aboutSaysWhichVersionItIs() {
    TouchedWindow program;
    QCoreApplication::setApplicationVersion(QStringLiteral("12.34"));
    QString said;
    QTimer::singleShot(200, program.window.get(), [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            said = box->text();
            box->accept();
        }
    });
    program.command("about").trigger();
    QCoreApplication::setApplicationVersion({});
    COMPARE_CONTAINS(said, QStringLiteral("Tactum 12.34"));
}

void TestWindow::everyKeyIsGivenOnce() {
    QStringList keys;
    for (const Command& command : commands())
        for (const QString& key :
             QString::fromLatin1(command.keys).split(QStringLiteral("; "), Qt::SkipEmptyParts)) {
            QVERIFY2(!QKeySequence::fromString(key).isEmpty(), qPrintable(key));
            QVERIFY2(!keys.contains(key), qPrintable(key));
            keys << key;
        }
}

// Fifteen degrees at a time, straight up and down at most.
void TestWindow::keysTurnTheCamera() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    SceneView& view = program.window->view();
    view.showStandardView(StandardView::Front);
    const auto turn = [&](const char* id, int times) {
        for (int i = 0; i < times; ++i)
            program.command(id).trigger();
    };
    turn("orbit-right", 6);
    COMPARE_NEAR(view.camera().yaw, M_PI / 2, 1e-9, "rad");
    turn("orbit-left", 6);
    turn("orbit-up", 20);
    QCOMPARE_LT(std::abs(view.camera().yaw), 1e-9);
    COMPARE_NEAR(view.camera().pitch, M_PI / 2, 1e-9, "rad");
    const double distance = view.camera().distance;
    turn("zoom-in", 2);
    COMPARE_NEAR(view.camera().distance, 0.64 * distance, 1e-9, "m");
    turn("zoom-out", 2);
    COMPARE_NEAR(view.camera().distance, distance, 1e-9, "m");
}

void TestWindow::undoneStepsAreDim() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("stiffness"), QStringLiteral("300"));
    program.type(QStringLiteral("stiffness"), QStringLiteral("400"));
    auto* dock = program.window->findChild<QDockWidget*>(QStringLiteral("dock-history"));
    dock->show(); // another test may have left it hidden
    dock->raise();
    auto* list = program.window->findChild<HistoryList*>();
    QTRY_VERIFY(!list->visibleRegion().isEmpty());
    program.frames(5);
    const auto brightest = [&](int row) {
        const QImage picture = list->grab(list->visualRect(list->model()->index(row, 0))).toImage();
        int most = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                most = std::max(most, qGray(picture.pixel(x, y)));
        return most;
    };
    const int done = brightest(2);
    program.document.history().undo();
    program.frames(3);
    QCOMPARE_LT(brightest(2), done - 40);
    COMPARE_NEAR(brightest(1), done, 10, "");
    // Del here is not the window's, which deletes objects.
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(1, 0)).center());
    QTest::keyClick(list, Qt::Key_Delete);
    QVERIFY(!program.document.empty());
}

TACTUM_GUI_TEST(TestWindow)

} // namespace test_window

#include "test_window.moc"
