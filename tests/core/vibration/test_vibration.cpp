// What of a force is vibration: sines go through as they are, pushes do not, and three axes become one with
// their power. The test itself would be wrong if its sines had another frequency than they say: rows are at t
// = i / rate.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/haptics/compile.h"
#include "core/vibration/envelope.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_vibration {

using namespace tactum;
using namespace tactum::test;

namespace {

double sine(double frequency, double t) {
    return std::sin(2 * std::numbers::pi * frequency * t);
}

template <typename Force> TouchTrace strokeOf(double seconds, double rate, Force force) {
    TouchTrace rows;
    for (int i = 0; i <= int(seconds * rate + 0.5); ++i) {
        TouchRow row;
        row.t = 5 + i / rate; // a path begins when it likes
        row.force = force(i / rate);
        rows.push_back(row);
    }
    return rows;
}

/// Of what is left of a sine, by the filter's own formula.
double keptOf(double frequency) {
    return 1 / (1 + std::pow(kSlowestVibration / frequency, 4));
}

/// The largest difference to a sine, away from the ends, where the stroke's beginning and end are heard.
double awayFrom(const Vibration& vibration, double amplitude, double frequency) {
    double away = 0;
    const std::size_t count = vibration.force.size();
    for (std::size_t i = count / 5; i < count * 4 / 5; ++i)
        away = std::max(
            away, std::abs(vibration.force[i] - amplitude * sine(frequency, double(i) / vibration.rate)));
    return away;
}

/// How like itself a vibration is so many samples later, in its middle: 1 for the same, -1 for the opposite.
double alike(const Vibration& vibration, std::size_t later) {
    double both = 0, all = 0;
    for (std::size_t i = vibration.force.size() / 3; i < vibration.force.size() * 2 / 3; ++i) {
        both += vibration.force[i] * vibration.force[i + later];
        all += vibration.force[i] * vibration.force[i];
    }
    return both / all;
}

} // namespace

class TestVibration : public QObject {
    Q_OBJECT

private slots:
    void aSineOnAPushIsThatSine_data() {
        QTest::addColumn<double>("frequency");
        QTest::addColumn<double>("rate");
        QTest::newRow("slow") << 30.0 << 1000.0;
        QTest::newRow("middle") << 80.0 << 1000.0;
        QTest::newRow("fast") << 400.0 << 1000.0;
        QTest::newRow("fast path") << 1500.0 << 4000.0;
        QTest::newRow("as fast as it is played") << 1500.0 << 8000.0;
    }

    void aSineOnAPushIsThatSine() {
        QFETCH(double, frequency);
        QFETCH(double, rate);
        const auto vibration = vibrationOf(
            strokeOf(2, rate, [&](double t) { return Vec3(0, 2 + 0.3 * sine(frequency, t), 0); }));
        QCOMPARE(vibration->force.size(), std::size_t(16001));
        COMPARE_NEAR(awayFrom(*vibration, 0.3 * keptOf(frequency), frequency), 0, 0.003, "N");
    }

    /// 0.3 and 0.4 N across each other are 0.5 N, in step or not.
    void axesAddTheirPower() {
        for (const double shift : {0.0, 0.25}) {
            const auto vibration = vibrationOf(strokeOf(2, 1000, [&](double t) {
                return Vec3(0.3 * sine(100, t), 0, 0.4 * sine(100, t + shift / 100));
            }));
            const auto middle = envelopeOf(*vibration)[100];
            COMPARE_NEAR(middle.amplitude, 0.5 * keptOf(100), 0.005, "N");
            COMPARE_NEAR(middle.frequency, 100, 1, "Hz");
        }
    }

    void aPushIsNone() {
        const auto vibration = vibrationOf(strokeOf(2, 1000, [](double t) {
            return Vec3(0, 1.5 - 1.5 * std::cos(std::numbers::pi * t), 0); // up to 3 N and down again
        }));
        COMPARE_NEAR(peakOf(*vibration), 0, 1e-3, "N");
    }

    /// The rate of rows is the path's affair: at 250 a second 100 Hz are still 100 Hz.
    void rowsThatComeSlowlyAreTakenAtTheirTimes() {
        const auto vibration =
            vibrationOf(strokeOf(2, 250, [](double t) { return Vec3(sine(40, t), 0, 0); }));
        COMPARE_NEAR(envelopeOf(*vibration)[100].frequency, 40, 4, "Hz"); // straight lines between rows
    }

    void theEnvelopeFollows() {
        const auto vibration = vibrationOf(strokeOf(
            2, 1000, [](double t) { return Vec3(t < 1 ? 0.1 * sine(60, t) : 0.4 * sine(240, t), 0, 0); }));
        const std::vector<EnvelopePoint> points = envelopeOf(*vibration);
        COMPARE_NEAR(points[50].amplitude, 0.1 * keptOf(60), 0.001, "N");
        COMPARE_NEAR(points[50].frequency, 60, 1, "Hz");
        COMPARE_NEAR(points[150].amplitude, 0.4 * keptOf(240), 0.004, "N");
        COMPARE_NEAR(points[150].frequency, 240, 2.4, "Hz");
        COMPARE_NEAR(points.back().t, 2, 0.01, "s");
    }

    /// Grooves every 2 mm, stroked at 0.1 m/s: 50 Hz, whatever their form is.
    void groovesVibrateAtSpeedOverTheirWidth() {
        SceneObject sheet;
        TriangleSoup soup;
        soup.positions = {{-0.2, 0, -0.2}, {0.2, 0, -0.2}, {0.2, 0, 0.2}, {-0.2, 0, 0.2}};
        soup.triangles = {{2, 1, 0}, {3, 2, 0}};
        sheet.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
        sheet.surfaces.resize(1);
        TextureLayer layer;
        layer.pattern.source = TextureSource::Grooves;
        layer.pattern.size = 2e-3;
        layer.pattern.softness = 1;
        layer.strength = 1e-4;
        sheet.surfaces[0].layers = {layer};
        Scene scene;
        scene.objects = {sheet};
        std::vector<FingerPoint> stroke;
        for (int i = 0; i <= 1000; ++i) // comes down from 3 mm above to 1 mm below
            stroke.push_back({i / 1000.0, {0, std::max(3e-3 - 2e-5 * i, -1e-3), -0.05 + 1e-4 * i}});
        const Vibration vibration = *vibrationOf(replay(**compile(scene), stroke));
        COMPARE_NEAR(alike(vibration, 160), 1, 0.02, "of all power"); // 20 ms later
        COMPARE_NEAR(alike(vibration, 80), -1, 0.5, "of all power");
    }

    void aStrokeHasALength() {
        const auto none = [](double) { return Vec3(Vec3::Zero()); };
        QVERIFY(!vibrationOf({}));
        QVERIFY(!vibrationOf(strokeOf(0, 1000, none)));
        COMPARE_CONTAINS(vibrationOf(strokeOf(601, 10, none)).error().text, "ten minutes");
        COMPARE_NEAR(peakOf(*vibrationOf(strokeOf(1, 1000, none))), 0, 1e-12, "N");
    }
};

TACTUM_TEST(TestVibration)

} // namespace test_vibration

#include "test_vibration.moc"
