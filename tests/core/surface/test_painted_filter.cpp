// What is painted on a fine mesh is not felt as something else where it passes too fast for the steps.
//
// What would show that a test here is wrong: waves that a finger crosses slowly, or goes along, must be whole
// in the same rows, and the mesh alone, without a way that passes, must show all of them.
#include <QTest>

#include "core/geometry/weld.h"
#include "tests/core/surface/spectrum.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/uneven_grid.h"

namespace test_painted_filter {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kCell = 1e-4, kHeight = 1e-5, kPi = std::numbers::pi;

/// A strip in the plane z = 0, painted: cells of a tenth of a millimetre, halved by the diagonal.
class Strip {
public:
    template <class Height> Strip(int along, int across, Height&& height) : across_(across) {
        Rng rng(1);
        soup_ = unevenGrid(along, across, 0, true, rng,
                           [](double x, double y) { return Vec3(kCell * Vec3(x, y, 0)); });
        const std::vector<Index> place = weldMap(soup_->positions);
        std::vector<float> values;
        for (std::size_t i = 0; i < place.size(); ++i)
            values.push_back(place[i] == i ? float(height(soup_->positions[i])) : values[place[i]]);
        TextureLayer layer = heightLayer(TextureSource::Painted, TextureMapping::Planar, 0.01, kHeight);
        layer.pattern.painted = {std::make_shared<const PaintedValues>(std::move(values))};
        stack_ = stackOf({layer}, soup_);
    }

    /// `passing`: the smallest feature and which way it passes, m.
    TextureFeel at(double x, double y, const Vec3& passing) const {
        const double u = x / kCell, v = y / kCell, i = std::floor(u), k = std::floor(v), s = u - i, t = v - k;
        TexturePoint point;
        point.position = {x, y, 0};
        point.triangle = Index(2 * (i * across_ + k) + (s < t));
        point.weights = s < t ? Vec3(1 - t, s, t - s) : Vec3(1 - s, s - t, t);
        point.passing = passing;
        return feel(*stack_, point, passing.norm());
    }

    /// What is kept of the slope, root mean square, well inside.
    double kept(const Vec3& passing, double length, double width) const {
        Rng rng(2);
        double filtered = 0, whole = 0;
        for (int round = 0; round < 1000; ++round) {
            const double x = uniform(rng, 0.2, 0.8) * length, y = uniform(rng, 0.3, 0.7) * width;
            filtered += at(x, y, passing).slope.squaredNorm();
            whole += at(x, y, Vec3::Zero()).slope.squaredNorm();
        }
        return std::sqrt(filtered / whole);
    }

private:
    int across_;
    Soup soup_;
    Stack stack_;
};

} // namespace

class TestPaintedFilter : public QObject {
    Q_OBJECT

private slots:
    /// Of waves as long as the feature or shorter nothing is left, of those eight times as long all, and of
    /// waves that are not crossed but gone along all.
    void wavesThatPassTooFastVanish_data() {
        QTest::addColumn<double>("features"); // long
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        // Fewer than three vertices to a wave: what lies between them shows others as well, shorter ones.
        QTest::newRow("0.7") << 0.7 << 0.0 << 0.1;
        QTest::newRow("1") << 1.0 << 0.0 << 0.04;
        QTest::newRow("2") << 2.0 << 0.6 << 0.8;
        QTest::newRow("4") << 4.0 << 0.96 << 1.0;
        QTest::newRow("8") << 8.0 << 0.995 << 1.001;
        QTest::newRow("16") << 16.0 << 0.999 << 1.001;
    }
    void wavesThatPassTooFastVanish() {
        QFETCH(double, features);
        QFETCH(double, least);
        QFETCH(double, most);
        constexpr double kFeature = 4e-4;
        const int cells = std::max(200, int(6 * features * kFeature / kCell));
        const double length = features * kFeature;
        const Strip strip(cells, 60,
                          [&](const Vec3& p) { return 0.5 + 0.2 * std::sin(2 * kPi * p.x() / length); });
        const double kept = strip.kept(Vec3(kFeature, 0, 0), cells * kCell, 60 * kCell);
        QCOMPARE_GE(kept, least);
        QCOMPARE_LE(kept, most);
        COMPARE_NEAR(strip.kept(Vec3(0, kFeature, 0), cells * kCell, 60 * kCell), 1, 0.015, "");
        COMPARE_NEAR(strip.kept(Vec3(0, 0, kFeature), cells * kCell, 60 * kCell), 1, 1e-12, "");
        COMPARE_NEAR(strip.kept(Vec3(0.9 * kCell, 0, 0), cells * kCell, 60 * kCell), 1, 1e-12, "");
    }

    /// From a finger that stands to one that is fast nothing jumps, and from triangle to triangle no more
    /// than without the filter.
    void nothingJumps() {
        Rng rng(3);
        const Strip strip(120, 60, [&](const Vec3&) { return uniform(rng, 0.3, 0.7); });
        double withSpeed = 0, withPlace = 0, bare = 0, steepest = 0;
        const auto change = [](double& most, const Vec3& before, const Vec3& now) {
            most = std::max(most, (now - before).norm());
            return now;
        };
        for (int round = 0; round < 100; ++round) {
            const double x = uniform(rng, 3e-3, 9e-3), y = uniform(rng, 2e-3, 4e-3);
            const Vec3 way = Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), 0).normalized();
            Vec3 felt = strip.at(x, y, Vec3::Zero()).slope;
            steepest = std::max(steepest, felt.norm());
            for (double feature = 0; feature < 7; feature += 0.01)
                felt = change(withSpeed, felt, strip.at(x, y, feature * kCell * way).slope);
            const Vec3 passing = 3 * kCell * way;
            felt = strip.at(x, y, passing).slope;
            Vec3 whole = strip.at(x, y, Vec3::Zero()).slope;
            for (int i = 1; i < 300; ++i) {
                felt = change(withPlace, felt, strip.at(x + 1e-6 * i, y, passing).slope);
                whole = change(bare, whole, strip.at(x + 1e-6 * i, y, Vec3::Zero()).slope);
            }
        }
        qInfo("a hundredth of a cell faster %.3g, a hundredth on %.3g, unfiltered %.3g; slopes up to %.3g",
              withSpeed, withPlace, bare, steepest);
        QCOMPARE_LT(withSpeed, 0.05 * steepest);
        QCOMPARE_LT(withPlace, bare);
    }

    /// White grain, the worst there is, beside what a picture of it does (test_texture_filter).
    void aliasOfASlide_data() {
        QTest::addColumn<double>("rate");
        QTest::newRow("1 kHz") << 1000.0;
        QTest::newRow("2 kHz") << 2000.0;
    }
    void aliasOfASlide() {
        QFETCH(double, rate);
        constexpr double kSpeed = 0.15, kSteps = 2.5;
        constexpr int kTicks = 512;
        Rng rng(9);
        const Strip strip(int(kSpeed * kTicks / rate / kCell) + 60, 60,
                          [&](const Vec3&) { return uniform(rng, 0, 1); });
        const Vec3 way = Vec3(1, 0.01, 0).normalized();
        const auto slide = [&](const Vec3& passing) {
            std::vector<double> slopes;
            for (int i = 0; i < kTicks; ++i) {
                const Vec3 place = Vec3(3e-3, 2.5e-3, 0) + kSpeed * i / rate * way;
                slopes.push_back(strip.at(place.x(), place.y(), passing).slope.dot(way));
            }
            return spectrumOf(slopes, rate, 0.4 * rate);
        };
        const Spectrum sharp = slide(Vec3::Zero()), soft = slide(kSteps * kSpeed / rate * way);
        qInfo("force above %g Hz: %.3g mN, %.2f %% of the energy; unfiltered %.3g mN, %.1f %%", 0.4 * rate,
              1e3 * std::sqrt(soft.above), 100 * soft.above / soft.whole, 1e3 * std::sqrt(sharp.above),
              100 * sharp.above / sharp.whole);
        QCOMPARE_LT(soft.above, 0.02 * soft.whole);
        QCOMPARE_LT(soft.above, 0.01 * sharp.above);
        QCOMPARE_GT(soft.whole, 0);
    }
};

TACTUM_TEST(TestPaintedFilter)

} // namespace test_painted_filter

#include "test_painted_filter.moc"
