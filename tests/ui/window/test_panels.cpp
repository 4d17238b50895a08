// The room that the panels leave to the view: what is folded, by whom, and until when.
#include <QDockWidget>
#include <QSettings>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"

namespace test_panels {

using namespace tactum;

namespace {

QTabBar* tabsOf(const TouchedWindow& program, const QString& first) {
    for (auto* bar : program.window->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        if (bar->isVisible() && bar->tabText(0) == first) return bar;
    return nullptr;
}

} // namespace

class TestPanels : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        unfoldPlots();
    }

    void theViewHasItsRoom_data();
    void theViewHasItsRoom();
    void thePlotsComeWithTheFirstForce();
    void whatIsFoldedStaysSo();
};

/// Of the whole window; the plots of somebody who never saw one are folded.
void TestPanels::theViewHasItsRoom() {
    QFETCH(QSize, screen);
    QFETCH(bool, folded);
    QFETCH(int, across);
    QFETCH(int, down);
    QSettings().setValue(QStringLiteral("window/folded"),
                         folded ? QStringList{QStringLiteral("dock-plot")} : QStringList());
    TouchedWindow program(MainWindow::firstSize(screen));
    QVERIFY(program.open(writeCube(folder_)));
    const QSize window = program.window->size(), view = program.window->view().size();
    QCOMPARE_GE(100 * view.width(), across * window.width());
    QCOMPARE_GE(100 * view.height(), down * window.height());
}

void TestPanels::theViewHasItsRoom_data() {
    QTest::addColumn<QSize>("screen");
    QTest::addColumn<bool>("folded");
    QTest::addColumn<int>("across"); // percent
    QTest::addColumn<int>("down");
    QTest::newRow("1280 x 800") << QSize(1280, 840) << false << 60 << 55;
    QTest::newRow("1280 x 800, folded") << QSize(1280, 840) << true << 60 << 75;
    QTest::newRow("1600 x 1000, folded") << QSize(1600, 1000) << true << 65 << 80;
    QTest::newRow("1920 x 1080") << QSize(1920, 1120) << false << 70 << 60;
    QTest::newRow("1920 x 1080, folded") << QSize(1920, 1120) << true << 70 << 80;
}

/// The model stays where it is under the finger; only when it has gone the plots come.
void TestPanels::thePlotsComeWithTheFirstForce() {
    QSettings().remove(QStringLiteral("window/folded"));
    TouchedWindow program;
    const auto& plot = *program.window->findChild<QDockWidget*>(QStringLiteral("dock-plot"));
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.fullForce());
    const QSize view = program.window->view().size();
    QCOMPARE(plot.height(), 0);
    QVERIFY(program.command("fold-plots").isChecked());
    const QPoint at = program.centre();
    program.press(at);
    QVERIFY(test::waitFor([&] {
        program.frames(2);
        return program.touch().contacts > 0;
    }));
    QCOMPARE(program.window->view().size(), view);
    program.release(at);
    QVERIFY(test::waitFor([&] {
        program.frames(2);
        return plot.height() > 100;
    }));
    QCOMPARE_LT(program.window->view().height(), view.height() - 100);
    QVERIFY(!program.command("fold-plots").isChecked());
    program.window->close();
    // Nobody has decided it: the next one begins as this one did.
    QVERIFY(!QSettings().contains(QStringLiteral("window/folded")));
}

void TestPanels::whatIsFoldedStaysSo() {
    {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        const auto dock = [&](const char* name) {
            return program.window->findChild<QDockWidget*>(QLatin1String(name));
        };
        const auto &plot = *dock("dock-plot"), &health = *dock("dock-health");
        program.frames(10); // the docks have their places
        const int before = plot.height();
        QCOMPARE_GT(before, 100);
        QTabBar* bar = tabsOf(program, QStringLiteral("Force"));
        QVERIFY(bar);
        auto* button = bar->findChild<QToolButton*>(QStringLiteral("fold"));
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(plot.height(), 0);
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(1).center()); // another one of them
        QTRY_COMPARE(health.height(), before);
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(health.height(), 0);
        // All panels away and back: it is still folded.
        program.command("panels").trigger();
        program.frames(3);
        program.command("panels").trigger();
        program.frames(3);
        QVERIFY(program.command("fold-plots").isChecked());
        program.command("fold-plots").trigger();
        QTRY_COMPARE(health.height(), before);
        program.command("fold-plots").trigger();
        program.command("fold-lists").trigger();
        program.window->close();
    }
    TouchedWindow again;
    QVERIFY(again.open(writeCube(folder_)));
    QTRY_COMPARE(again.window->findChild<QDockWidget*>(QStringLiteral("dock-plot"))->height(), 0);
    QTRY_COMPARE(again.window->findChild<QDockWidget*>(QStringLiteral("dock-presets"))->height(), 0);
    QVERIFY(again.command("fold-lists").isChecked());
}

TACTUM_GUI_TEST(TestPanels)

} // namespace test_panels

#include "test_panels.moc"
