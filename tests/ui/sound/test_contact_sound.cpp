#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/sound/contact_sound.h"

namespace test_contact_sound {

using namespace tactum;

namespace {

constexpr double kTick = 1e-3; // s

/// The force at each tick for some seconds.
template <class Force> std::vector<Vec3> forces(double seconds, Force force) {
    std::vector<Vec3> list;
    for (int i = 0; i < int(std::lround(seconds / kTick)); ++i)
        list.push_back(force(i * kTick));
    return list;
}

double sine(double frequency, double t) {
    return std::sin(2 * std::numbers::pi * frequency * t);
}

std::span<const float> lastHalf(const std::vector<float>& samples) {
    return std::span(samples).last(samples.size() / 2);
}

double rms(std::span<const float> samples) {
    double sum = 0;
    for (float s : samples)
        sum += double(s) * double(s);
    return std::sqrt(sum / double(samples.size()));
}

/// Amplitude of one frequency in it, over a whole number of its periods.
double amplitude(std::span<const float> samples, double frequency) {
    double c = 0, s = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double angle = 2 * std::numbers::pi * frequency * double(i) / kSoundRate;
        c += double(samples[i]) * std::cos(angle);
        s += double(samples[i]) * std::sin(angle);
    }
    return 2 * std::hypot(c, s) / double(samples.size());
}

} // namespace

class TestContactSound : public QObject {
    Q_OBJECT
private slots:
    void silenceGivesSilence() {
        ContactSound sound;
        const auto samples = sound(forces(0.5, [](double) { return Vec3(Vec3::Zero()); }));
        QCOMPARE_LE(std::abs(int(samples.size()) - kSoundRate / 2), 1);
        QCOMPARE(rms(samples), 0.0);
    }

    void aConstantForceIsSilent() {
        ContactSound sound;
        const auto samples = sound(forces(0.5, [](double) { return Vec3(1, 5, -2); }));
        QCOMPARE_LT(rms(samples), 1e-9);
    }

    void whatShakesIsHeardWithItsFrequency_data() {
        QTest::addColumn<double>("frequency");
        for (const double f : {30.0, 100.0, 250.0, 400.0})
            QTest::addRow("%g Hz", f) << f;
    }
    void whatShakesIsHeardWithItsFrequency() {
        QFETCH(double, frequency);
        ContactSound sound;
        const Vec3 along = Vec3(2, -1, 0.5).normalized();
        const auto samples = sound(
            forces(2, [&](double t) { return Vec3(Vec3(0, 4, 0) + 0.1 * sine(frequency, t) * along); }));
        const auto steady = lastHalf(samples);
        const double heard = amplitude(steady, frequency), all = std::numbers::sqrt2 * rms(steady);
        QVERIFY2(heard > 0.98 * all, qPrintable(QString("%1 of %2").arg(heard).arg(all)));
        // Half of full scale for a newton; the high-pass lets 30 Hz through by 91 %.
        QVERIFY2(heard > 0.04 && heard < 0.055, qPrintable(QString::number(heard)));
    }

    void slowerThanTwentyHertzIsNotHeard() {
        ContactSound sound;
        const auto samples = sound(forces(4, [](double t) { return Vec3(0, 1 + sine(1, t), 0); }));
        QCOMPARE_LT(rms(lastHalf(samples)), 2e-3);
    }

    void noForceIsLouderThanFullScale() {
        ContactSound sound;
        const auto samples = sound(forces(1, [](double t) { return Vec3(0, 1e4 * sine(80, t), qQNaN()); }));
        const auto loud = sound(forces(1, [](double t) { return Vec3(0, 1e4 * sine(80, t), 0); }));
        QCOMPARE(rms(samples), 0.0); // not a force
        for (float s : loud)
            QCOMPARE_LE(std::abs(s), 1);
        QCOMPARE_GT(rms(loud), 0.7);
    }

    void piecesSoundAsTheWhole() {
        const auto all = forces(0.3, [](double t) { return Vec3(0.2 * sine(60, t), 1, 0.1 * sine(170, t)); });
        ContactSound whole, parts;
        const auto expected = whole(all);
        std::vector<float> joined;
        for (std::size_t i = 0; i < all.size(); i += 17) {
            const auto piece = parts(std::span(all).subspan(i, std::min<std::size_t>(17, all.size() - i)));
            joined.insert(joined.end(), piece.begin(), piece.end());
        }
        QCOMPARE_EQ(joined, expected);
    }

    void everyServoRateGivesASecondOfSamplesForASecond() {
        for (const double rate : {1000.0, 3000.0, 4096.0}) {
            ContactSound sound(rate);
            const std::vector<Vec3> second(std::size_t(rate), Vec3::UnitX());
            QCOMPARE_LE(std::abs(int(sound(second).size()) - kSoundRate), 1);
        }
    }
};

TACTUM_TEST(TestContactSound)

} // namespace test_contact_sound

#include "test_contact_sound.moc"
