// Measures in closed form, the places that clicks mean, and what is drawn of them.
#include <QPainter>
#include <QTest>

#include "core/scene/placing.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/support/soups.h"
#include "ui/base/preferences.h"
#include "ui/view/handles.h"
#include "ui/view/measure.h"

namespace test_measure {

using namespace tactum;
using namespace tactum::test;

namespace {

/// A thousand pixels to a metre at the focus, looked at from the front.
ViewCamera camera() {
    ViewCamera c;
    c.size = {800, 600};
    c.fieldOfView = 0.6;
    c.distance = 0.3 / std::tan(0.3);
    return c;
}

/// Of an edge the point is meant that the ray passes, which is not quite the one that looks nearest.
constexpr double kHundredthPixel = 1e-5; // m

/// A right angle at the origin, legs of 0.2 m to the right and up.
TriangleSoup corner() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {0.2, 0, 0}, {0, 0.2, 0}};
    soup.triangles = {{0, 1, 2}};
    soup.surfaceOf = {0};
    return soup;
}

Vec3 snapped(const Vec3& hit_B, QPointF off, const Pose& pose = {},
             const std::optional<SectionPlane>& section = {}) {
    const Vec3 hit = pose.apply(hit_B);
    return snappedTo(corner(), 0, pose, hit, *camera().project(hit) + off, camera(), section);
}

} // namespace

class TestMeasure : public QObject {
    Q_OBJECT

private slots:
    void numbersOfABoxAreThoseOfItsSides() {
        const Vec3 low(-0.03, 0.01, 0.02), high(0.03, 0.05, 0.14); // 60 x 40 x 120 mm, 140 across
        const std::vector<Vec3> ends{low, high};
        const auto numbers = numbersOf(ends);
        QVERIFY(numbers);
        COMPARE_NEAR(numbers->way, Vec3(0.06, 0.04, 0.12), 1e-15, "m");
        COMPARE_NEAR(numbers->way.norm(), 0.14, 1e-15, "m");
        QVERIFY(!numbers->angle);
        QVERIFY(!numbersOf({ends.data(), 1}));
    }

    void anglesAreBetweenTheLegs() {
        const auto angle = [](const Vec3& a, const Vec3& b, const Vec3& c) {
            const std::vector<Vec3> points{a, b, c};
            return *numbersOf(points)->angle;
        };
        const Vec3 o(1, 2, 3), x = Vec3::UnitX(), y = Vec3::UnitY();
        COMPARE_NEAR(angle(o + x, o, o + 5 * y), EIGEN_PI / 2, 1e-12, "rad");
        COMPARE_NEAR(angle(o + x, o, o + x + y), EIGEN_PI / 4, 1e-12, "rad");
        COMPARE_NEAR(angle(o + x, o, o - 2 * x), EIGEN_PI, 1e-12, "rad");
        COMPARE_NEAR(angle(o + x, o, o + x), 0, 1e-12, "rad");
        COMPARE_NEAR(angle(o, o, o), 0, 1e-12, "rad"); // of no legs
    }

    void cornersAndEdgesNearTheCursorAreMeant() {
        COMPARE_NEAR(snapped({0.004, 0.003, 0}, {}), Vec3::Zero(), 1e-12, "m"); // five pixels away
        COMPARE_NEAR(snapped({0.1, 0.004, 0}, {}), Vec3(0.1, 0, 0), kHundredthPixel,
                     "m");                                                           // four from an edge
        COMPARE_NEAR(snapped({0.06, 0.05, 0}, {}), Vec3(0.06, 0.05, 0), 1e-12, "m"); // of nothing
        // Beside the model, where the ray of another pixel met it.
        COMPARE_NEAR(snapped({0.002, 0.002, 0}, {-7, 5}), Vec3::Zero(), 1e-12, "m");
    }

    void placesAreThoseOfTheBodyWhereItIs() {
        const Pose pose{Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())), {-0.1, 0.02, 0.05}};
        COMPARE_NEAR(snapped({0.004, 0.003, 0}, {}, pose), pose.translation, 1e-12, "m");
    }

    void whatIsCutAwayIsNotMeant() {
        // What lies left of 3 mm is away, with the corner and a part of the lower edge.
        const SectionPlane cut{{Quat::FromTwoVectors(Vec3::UnitZ(), -Vec3::UnitX()), {0.003, 0, 0}}};
        COMPARE_NEAR(snapped({0.006, 0.004, 0}, {}, {}, cut), Vec3(0.006, 0, 0), kHundredthPixel, "m");
    }

    void wordsAreInTheUnitThatIsPreferred() {
        Preferences& preferences = Preferences::instance();
        const double before = preferences.value(Preferred::Lengths);
        const std::vector<Vec3> points{{0, 0, 0}, {0.06, 0.08, 0}, {0.06, 0, 0}};
        QCOMPARE(measuredLines(*numbersOf(points)),
                 "Distance 100.00 mm\ndx 60.00 mm\ndy 80.00 mm\ndz 0.00 mm\nAngle 36.9\u00b0");
        QCOMPARE(measuredText(0.1234567), "123.46 mm");
        QCOMPARE(measuredText(-12.5e-6), "-0.0125 mm");
        for (int i = 0; i < int(std::size(kLengthUnits)); ++i) {
            preferences.set(Preferred::Lengths, i);
            COMPARE_CONTAINS(measuredText(1), std::string(kLengthUnits[std::size_t(i)].name).c_str());
        }
        preferences.set(Preferred::Lengths, before);
    }

    void lineAndNumbersAreDrawn() {
        const auto drawn = [](std::vector<Vec3> points, const std::optional<Vec3>& next = {}) {
            return drawnBy({800, 600},
                           [&](QPainter& p) { drawMeasure(p, points, next, camera(), kDarkTheme); });
        };
        const QString nothing = drawn({});
        QVERIFY(drawn({{0, 0, 0}}) != nothing);
        QVERIFY(drawn({{0, 0, 0}}, Vec3(0.1, 0, 0)) != drawn({{0, 0, 0}}));
        QVERIFY(drawn({{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}) != drawn({{0, 0, 0}, {0.1, 0, 0}}));
        QCOMPARE(drawn({{0, 0, 9}, {0, 0.1, 9}}), nothing); // behind the eye
    }

    void numbersAreBesideWhatCoversThem() {
        const std::vector<Vec3> points{{-0.1, 0.27, 0}, {0.1, 0.27, 0}, {0.1, 0.2, 0}};
        const QRectF view(0, 0, 800, 600);
        const auto usual = measureBoxes(points, camera(), QFont(), {});
        QCOMPARE(usual.size(), std::size_t(2)); // the distance and the angle
        for (const QRegion& covered :
             {QRegion(0, 0, 800, 40), QRegion(0, 0, 500, 80),
              QRegion(0, 0, 350, 40) + QRegion(0, 40, 700, 40), QRegion(usual[0].toAlignedRect()),
              QRegion(usual[1].toAlignedRect())}) {
            const auto boxes = measureBoxes(points, camera(), QFont(), covered);
            QVERIFY(!boxes[0].intersects(boxes[1]));
            for (std::size_t i = 0; i < 2; ++i) {
                QVERIFY(view.contains(boxes[i]));
                QVERIFY(!covered.intersects(boxes[i].toAlignedRect()));
                QCOMPARE(boxes[i].size(), usual[i].size());
                QCOMPARE_LT(lengthOf(boxes[i].center() - usual[i].center()), 200); // still beside its line
            }
        }
        QCOMPARE(measureBoxes(points, camera(), QFont(), QRegion(0, 400, 800, 200)), usual);
    }

    void numbersAreInsideOfTheView() {
        const std::vector<Vec3> points{{0.35, 0.298, 0}, {0.39, 0.298, 0}}; // in the upper right corner
        QVERIFY(QRectF(0, 0, 800, 600).contains(measureBoxes(points, camera(), QFont(), {})[0]));
    }

    /// Also while the cursor is off the model, and there is no next one.
    void theFirstPointIsDrawnWhereItIs() {
        QImage picture(800, 600, QImage::Format_ARGB32_Premultiplied);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        const std::vector<Vec3> points{{0.05, 0.02, 0}};
        drawMeasure(painter, points, {}, camera(), kDarkTheme);
        painter.end();
        QCOMPARE(picture.pixelColor(camera().project(points[0])->toPoint()), kDarkTheme.accent);
    }
};

TACTUM_GUI_TEST(TestMeasure)

} // namespace test_measure

#include "test_measure.moc"
