// Where the panes of a divided view are, which of them a place is in, and what they are called.
#include <numbers>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/view/pane_mark.h"
#include "ui/view/view_panes.h"

namespace test_view_panes {

using namespace tactum;

namespace {

ViewPanes divided(ViewSplit split, QSize size = {402, 302}) {
    ViewPanes panes;
    panes.layOut(size);
    panes.setSplit(split);
    return panes;
}

std::vector<QRect> placesOf(const ViewPanes& panes) {
    std::vector<QRect> places;
    for (const std::size_t number : panes.shown())
        places.push_back(panes[number].place);
    return places;
}

} // namespace

class TestViewPanes : public QObject {
    Q_OBJECT
private slots:
    void aWholeViewIsOnePane() {
        const ViewPanes panes = divided(ViewSplit::One);
        QCOMPARE(placesOf(panes), std::vector{QRect(0, 0, 402, 302)});
        QVERIFY(!panes.isDivided() && !panes.linesAt({201, 151}));
        QCOMPARE(panes.at({-5, 700}), ViewPanes::kOwn);
    }

    void theyFillTheViewButForTheLinesBetween() {
        QCOMPARE(placesOf(divided(ViewSplit::Columns)),
                 (std::vector{QRect(0, 0, 200, 302), QRect(202, 0, 200, 302)}));
        QCOMPARE(placesOf(divided(ViewSplit::Rows)),
                 (std::vector{QRect(0, 0, 402, 150), QRect(0, 152, 402, 150)}));
        QCOMPARE(placesOf(divided(ViewSplit::Four)),
                 (std::vector{QRect(0, 0, 200, 150), QRect(202, 0, 200, 150), QRect(0, 152, 200, 150),
                              QRect(202, 152, 200, 150)}));
    }

    // However small the view is, or far the lines are led.
    void noneGoesAway() {
        for (const QSize size : {QSize(160, 120), QSize(402, 302), QSize(1900, 1000)})
            for (const QPointF to : {QPointF(-50, -50), QPointF(5000, 5000)}) {
                ViewPanes panes = divided(ViewSplit::Four, size);
                panes.lead(Qt::Horizontal | Qt::Vertical, to);
                for (const QRect& place : placesOf(panes)) {
                    QCOMPARE_GE(std::min(place.width(), place.height()), 38);
                    QVERIFY(QRect(QPoint(), size).contains(place));
                }
            }
    }

    void aPlaceIsInThePaneThatIsThere() {
        ViewPanes panes = divided(ViewSplit::Four);
        QCOMPARE(panes.at({10, 10}), ViewPanes::kTop);
        QCOMPARE(panes.at({300, 10}), ViewPanes::kOwn);
        QCOMPARE(panes.at({10, 300}), ViewPanes::kFront);
        QCOMPARE(panes.at({900, 900}), ViewPanes::kRight); // a drag goes on beyond the edge
        QCOMPARE(panes[ViewPanes::kRight].inside({212, 172}), QPointF(10, 20));
    }

    void aLineIsTakenNearIt() {
        const ViewPanes panes = divided(ViewSplit::Four);
        QCOMPARE(panes.linesAt({201, 20}), Qt::Orientations(Qt::Vertical));
        QCOMPARE(panes.linesAt({20, 153}), Qt::Orientations(Qt::Horizontal));
        QCOMPARE(panes.linesAt({202, 150}), Qt::Horizontal | Qt::Vertical);
        QVERIFY(!panes.linesAt({190, 20}));
        QVERIFY(!divided(ViewSplit::Rows).linesAt({201, 20}));
    }

    void theActiveOneIsUnderThePointerElseTheOneLastUsed() {
        ViewPanes panes = divided(ViewSplit::Four);
        QCOMPARE(panes.active(), ViewPanes::kOwn);
        QVERIFY(panes.pointAt({10, 10}) && !panes.pointAt({20, 20}));
        QCOMPARE(panes.active(), ViewPanes::kTop);
        QVERIFY(panes.pointNowhere());
        QCOMPARE(panes.active(), ViewPanes::kOwn);
        panes.pointAt({10, 300});
        panes.use();
        panes.pointAt({10, 10});
        panes.pointNowhere();
        QCOMPARE(panes.active(), ViewPanes::kFront);
        panes.setSplit(ViewSplit::Columns); // where it is not
        QCOMPARE(panes.active(), ViewPanes::kOwn);
    }

    void theyAreCalledByWhereTheyLookFrom() {
        ViewPanes panes;
        QCOMPARE(paneName(panes[ViewPanes::kFront].camera), QStringLiteral("Front, parallel"));
        QCOMPARE(paneName(panes[ViewPanes::kRight].camera), QStringLiteral("Right, parallel"));
        QCOMPARE(paneName(panes[ViewPanes::kTop].camera), QStringLiteral("Top, parallel"));
        ViewCamera camera = panes[ViewPanes::kOwn].camera;
        QCOMPARE(paneName(camera), QStringLiteral("Own view"));
        camera.pitch = 0;
        camera.yaw = std::numbers::pi;
        QCOMPARE(paneName(camera), QStringLiteral("Back"));
        camera.yaw = -0.5 * std::numbers::pi;
        QCOMPARE(paneName(camera), QStringLiteral("Left"));
        camera.pitch = -0.5 * std::numbers::pi;
        QCOMPARE(paneName(camera), QStringLiteral("Own view"));
        camera.yaw = 0;
        QCOMPARE(paneName(camera), QStringLiteral("Bottom"));
    }
};

TACTUM_TEST(TestViewPanes)

} // namespace test_view_panes

#include "test_view_panes.moc"
