// The pseudo-haptic pointer: how far it goes for a way of the mouse, by hand.
#include <cmath>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/view/lagging_cursor.h"

namespace test_lagging_cursor {

using namespace tactum;

class TestLaggingCursor : public QObject {
    Q_OBJECT

private slots:
    /// Of 0.6 N against the way, 1 - 0.6 / 1.5 is left; across it nothing changes.
    void theForceAlongTheWayCounts_data() {
        QTest::addColumn<QPointF>("push");
        QTest::addColumn<double>("way"); // pixels of ten
        QTest::newRow("none") << QPointF(0, 0) << 10.0;
        QTest::newRow("against") << QPointF(-0.6, 0) << 6.0;
        QTest::newRow("with") << QPointF(0.6, 0) << 14.0;
        QTest::newRow("across") << QPointF(0, 3) << 10.0;
        QTest::newRow("slanting") << QPointF(-0.6, 0.6) << 6.0;
        QTest::newRow("more than would hold it") << QPointF(-7, 0) << 2.0;
        QTest::newRow("much with it") << QPointF(7, 0) << 18.0;
    }
    void theForceAlongTheWayCounts() {
        QFETCH(QPointF, push);
        QFETCH(double, way);
        LaggingCursor cursor;
        cursor.begin({100, 50});
        for (int i = 1; i <= 10; ++i)
            cursor.follow({100.0 + i, 50}, push);
        COMPARE_NEAR(cursor.at().x() - 100, way, 1e-12, "px");
        QCOMPARE(cursor.at().y(), 50.0);
    }

    /// Back and forth through a place that pushes one way: what was lost is not given back.
    void itNeverGoesAgainstTheMouse() {
        LaggingCursor cursor;
        cursor.begin({0, 0});
        QPointF mouse, before;
        for (int i = 0; i < 1000; ++i) {
            const QPointF step(3 * std::sin(0.7 * i), 2 * std::cos(1.3 * i));
            const QPointF now = cursor.follow(mouse += step, {8 * std::sin(0.1 * i), 5 * std::cos(0.2 * i)});
            QCOMPARE_GE(QPointF::dotProduct(now - before, step), 0.0);
            before = now;
        }
        QCOMPARE(cursor.follow(mouse, {3, 3}), before); // a mouse that rests
    }
};

TACTUM_TEST(TestLaggingCursor)

} // namespace test_lagging_cursor

#include "test_lagging_cursor.moc"
