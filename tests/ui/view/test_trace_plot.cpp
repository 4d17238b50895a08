#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "ui/base/chart_axis.h"
#include "ui/view/trace_plot.h"

namespace test_trace_plot {

using namespace tactum;

namespace {

int rowsOfColour(const QImage& image, int x, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        count += image.pixelColor(x, y).rgb() == colour.rgb();
    return count;
}

} // namespace

class TestTracePlot : public QObject {
    Q_OBJECT

public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); } // draws into memory only
private slots:
    void stepsAreRound() {
        QCOMPARE(tickStep(10, 5), 2.0);
        QCOMPARE(tickStep(10, 10), 1.0);
        QCOMPARE(tickStep(0.9, 4), 0.5);
        COMPARE_NEAR(tickStep(0.0031, 5), 0.001, 1e-15, "");
        QCOMPARE(tickStep(9.9, 1), 10.0);
    }

    void aPeakOfOneSampleIsDrawn() {
        TouchTrace rows(20000);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].t = 1e-3 * double(i);
        rows[10000].force = {0, 0, 5};
        QImage image(800, 300, QImage::Format_RGB32);
        image.fill(Qt::white);
        {
            QPainter painter(&image);
            drawForcePlot(painter, QRectF(0, 0, 800, 300), rows, kLightTheme);
        }
        int tallest = 0;
        for (int x = 0; x < image.width(); ++x)
            tallest = std::max(tallest, rowsOfColour(image, x, kLightTheme.proxy));
        QCOMPARE_GT(tallest, 100);
    }

    void aSingleRowIsNoTrouble() {
        QImage image(400, 200, QImage::Format_RGB32);
        QPainter painter(&image);
        drawForcePlot(painter, QRectF(0, 0, 400, 200), TouchTrace(1), kLightTheme);
    }
};

TACTUM_GUI_TEST(TestTracePlot)

} // namespace test_trace_plot

#include "test_trace_plot.moc"
