#include <QApplication>
#include <QFile>
#include <QMenu>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/panels/touch_traces.h"
#include "ui/base/style.h"
#include "ui/widgets/force_plot.h"

namespace test_force_plot {

using namespace tactum;
using namespace tactum::testing;

namespace {

struct Shown {
    Shown() {
        plot.resize(800, 600);
        plot.take(pulled(0, 2), pulledTouch(), 8, 2000);
        plot.setSpan(2);
        plot.show();
        if (!QTest::qWaitForWindowExposed(&plot)) qFatal("no window");
    }
    StripChart& chart(const char* id) {
        return *plot.findChild<StripChart*>(QStringLiteral("strip-") + QString::fromLatin1(id));
    }
    /// Where a strip shows a value at a time.
    QPointF at(StripChart& chart, double t, double value, const StripAxis& axis, bool last = true) {
        StripTime time;
        time.axis = last;
        const QRectF area = stripArea(chart.rect(), time);
        const double end = plot.history().end();
        return {area.right() - (end - t) / plot.span() * area.width(),
                area.bottom() - (value - axis.low) / (axis.high - axis.low) * area.height()};
    }
    ForcePlot plot;
};

double difference(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

/// The least difference from a colour around a place of a widget.
double nearest(QWidget& widget, QPointF at, const QColor& colour) {
    const QImage picture = widget.grab().toImage();
    double least = 1e3;
    for (int dx = -2; dx <= 2; ++dx)
        for (int dy = -2; dy <= 2; ++dy) {
            const QPoint p = ((at + QPointF(dx, dy)) * picture.devicePixelRatio()).toPoint();
            if (picture.rect().contains(p))
                least = std::min(least, difference(picture.pixelColor(p), colour));
        }
    return least;
}

QByteArray contentOf(const QString& file) {
    QFile read(file);
    return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
}

} // namespace

class TestForcePlot : public QObject {
    Q_OBJECT
public:
    static void initMain() {
        QCoreApplication::setOrganizationName(QStringLiteral("TactumTest"));
        QCoreApplication::setApplicationName(QStringLiteral("TactumPlot"));
    }

private slots:
    void initTestCase() {
        QSettings().clear();
        applyTheme(ThemeChoice::Dark);
    }
    void cleanup() { QSettings().clear(); }

    void aStripIsWhereItsValueIs() {
        Shown shown;
        for (const char* id : {"force", "energy", "rate"})
            shown.plot.setShown(QString::fromLatin1(id), false);
        shown.plot.setShown(QStringLiteral("ratio"), true);
        QTest::qWait(50);
        StripChart& chart = shown.chart("ratio");
        StripTime time;
        // The largest is the tangential by normal force at the end: 2 / 2.
        const StripAxis axis = axisFor(0, 0.9995, stripLines(stripArea(chart.rect(), time)));
        for (const double t : {0.3, 1.0, 1.5})
            QCOMPARE_LT(nearest(chart, shown.at(chart, t, t / 2, axis), theme().stick), 60);
        QCOMPARE_GT(nearest(chart, shown.at(chart, 1.0, 0.9, axis), theme().stick), 100);
    }

    void buttonsChooseAndRemember() {
        {
            Shown shown;
            QVERIFY(shown.plot.isShown("force"));
            QVERIFY(!shown.plot.isShown("lag"));
            auto* lag = shown.plot.findChild<QToolButton*>(QStringLiteral("plot-lag"));
            QVERIFY(lag);
            QVERIFY(!lag->accessibleName().isEmpty());
            QTest::mouseClick(lag, Qt::LeftButton);
            QVERIFY(shown.plot.isShown("lag"));
            QVERIFY(shown.chart("lag").isVisible());
        }
        Shown again;
        QVERIFY(again.plot.isShown("lag"));
    }

    // The window can be no narrower than its panels: with the strips of a joint it was wider than 1280
    // pixels.
    void aNarrowPlotKeepsTheLastSwitchesInAMenu() {
        Shown shown;
        shown.plot.take(pulled(2, 3), pulledTouch(), 8, 2000, BodyReading{.turns = true, .slides = true});
        QCOMPARE_LT(shown.plot.minimumSizeHint().width(), 300);
        shown.plot.resize(300, 600);
        auto* energy = shown.plot.findChild<QToolButton*>(QStringLiteral("plot-body-energy"));
        auto* more = shown.plot.findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
        QTRY_VERIFY(!energy->isVisible());
        QVERIFY(more->isVisible());
        QVERIFY(more->menu()->actions().contains(energy->defaultAction()));
        energy->defaultAction()->trigger();
        QVERIFY(shown.plot.isShown("body-energy"));
    }

    void pauseHoldsTheTrace() {
        Shown shown;
        shown.plot.setPaused(true);
        shown.plot.take(pulled(2, 3), pulledTouch(), 8);
        QCOMPARE(shown.plot.history().samples().size(), std::size_t(2000));
        shown.plot.setPaused(false);
        shown.plot.take(pulled(2, 3), pulledTouch(), 8);
        QCOMPARE(shown.plot.history().samples().size(), std::size_t(3000));
    }

    void theWheelChangesTheTimeThatIsSeen() {
        Shown shown;
        StripChart& chart = shown.chart("force");
        QWheelEvent event(chart.rect().center(), chart.mapToGlobal(chart.rect().center()), {}, {0, 120},
                          Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&chart, &event);
        COMPARE_NEAR(shown.plot.span(), 1.6, 1e-9, "s");
        shown.plot.setSpan(1e6);
        QCOMPARE(shown.plot.span(), TouchHistory::kSpan);
    }

    void theCursorMarksAllStripsAtOneTime() {
        Shown shown;
        shown.plot.setShown(QStringLiteral("lag"), true);
        QTest::qWait(50);
        StripChart &force = shown.chart("force"), &lag = shown.chart("lag");
        const StripAxis any{0, 1, 1};
        const QPointF in = shown.at(force, 1.0, 0.5, any, false);
        const QPointF below = shown.at(lag, 1.0, 0.06, any);
        QCOMPARE_GT(nearest(lag, below, theme().text), 100);
        QMouseEvent move(QEvent::MouseMove, in, force.mapToGlobal(in), Qt::NoButton, {}, {});
        QApplication::sendEvent(&force, &move);
        QCOMPARE_LT(nearest(lag, below, theme().text), 60);
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&force, &leave);
        QCOMPARE_GT(nearest(lag, below, theme().text), 100);
    }

    void filesHoldWhatIsSeen() {
        Shown shown;
        QTemporaryDir folder;
        shown.plot.setSpan(0.5);
        QVERIFY(shown.plot.exportTo(folder.filePath("touch.csv")).has_value());
        const QByteArray csv = contentOf(folder.filePath("touch.csv"));
        QCOMPARE(csv.count('\n'), 502); // names, and half a second with both of its ends
        COMPARE_BEGINS(csv, "time (s),finger x (m),");
        QVERIFY(shown.plot.exportTo(folder.filePath("touch.png")).has_value());
        QCOMPARE(QImage(folder.filePath("touch.png")).size(), QSize(1920, 320));
        QVERIFY(shown.plot.exportTo(folder.filePath("touch.svg")).has_value());
        const QByteArray svg = contentOf(folder.filePath("touch.svg"));
        QVERIFY(svg.contains("<svg"));
        QVERIFY(svg.contains("Force, N"));
        QVERIFY(svg.contains("polyline"));
        const auto refused = shown.plot.exportTo(folder.filePath("touch.xyz"));
        QVERIFY(!refused);
        COMPARE_CONTAINS(refused.error().text, ".svg");
        QVERIFY(!shown.plot.exportTo(folder.filePath("none/touch.csv")).has_value());
    }
};

TACTUM_GUI_TEST(TestForcePlot)

} // namespace test_force_plot

#include "test_force_plot.moc"
