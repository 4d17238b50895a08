// T6: a limit cycle is noticed within a tenth of a second, stroking textures and tapping never are.
#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/control/oscillation_detector.h"
#include "tests/physics/servo.h"

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// s until a limit cycle of this form is noticed; 1 if it is not.
double noticedAfter(double frequency, double amplitude, double phase, const Vec3& axis, double rate,
                    double resolution, bool oneSided) {
    OscillationDetector detector;
    for (double t = 0; t < 1; t += 1 / rate) {
        double swing = std::sin(2 * kPi * frequency * t + phase);
        if (oneSided) swing = 2 * std::abs(std::sin(kPi * frequency * t + phase)) - 1; // as bounces are
        if (detector(counted(amplitude * swing * axis, resolution), 1 / rate)) return t;
    }
    return 1;
}

} // namespace

class TestStabilityOscillation : public QObject {
    Q_OBJECT

private slots:
    void limitCycleIsNoticedSoon_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<bool>("oneSided");
        for (const double rate : {1000.0, 2000.0, 4000.0})
            for (const bool oneSided : {false, true})
                QTest::addRow("%g Hz%s", rate, oneSided ? ", bouncing" : "") << rate << oneSided;
    }

    void limitCycleIsNoticedSoon() {
        QFETCH(double, rate);
        QFETCH(bool, oneSided);
        double worst = 0;
        for (const double frequency : {20.0, 22.5, 31.0, 50.0, 77.0, 100.0, 142.9, 166.7, 200.0, 249.0, 300.0})
            for (const double amplitude : {1e-4, 2e-4, 5e-4, 1e-3, 2e-3})
                for (int i = 0; i < 8; ++i)
                    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.577, 0.577, 0.577)})
                        for (const double resolution : {0.0, 30e-6, 60e-6}) {
                            const double after = noticedAfter(frequency, amplitude, i * kPi / 4, axis, rate,
                                                              resolution, oneSided);
                            worst = std::max(worst, after);
                            QVERIFY2(after <= 0.1, qPrintable(QString("%1 Hz, %2 mm, phase %3, axis %4, res %5: %6 s")
                                                                  .arg(frequency)
                                                                  .arg(1e3 * amplitude)
                                                                  .arg(i)
                                                                  .arg(axis.x())
                                                                  .arg(resolution)
                                                                  .arg(after)));
                        }
        qInfo("after %.1f ms at most", 1e3 * worst);
    }
};

QTEST_APPLESS_MAIN(TestStabilityOscillation)
#include "test_stability_oscillation.moc"
