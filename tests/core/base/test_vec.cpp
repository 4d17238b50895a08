// Turns of vectors, and the shortest turn from one direction to another. The test is wrong if it accepts a
// turn that does more than it must: the angle is compared with the one between the directions, by their sine
// and cosine.
#include <random>

#include <QTest>

#include "core/base/single_precision.h"
#include "core/base/vec.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_vec {

using namespace tactum;

class TestVec : public QObject {
    Q_OBJECT
private slots:
    /// 0.1, 0.2 and 0.3 as floats, from a table of IEEE 754 and not from a compiler: g++ 12.2 leaves two of
    /// three as they are.
    void aFloatHasSevenDigits() {
        const Vec3 single = asSingle(Vec3(0.1, 0.2, 0.3));
        QCOMPARE_EQ(single.x(), 0x1.99999ap-4);
        QCOMPARE_EQ(single.y(), 0x1.99999ap-3);
        QCOMPARE_EQ(single.z(), 0x1.333334p-2);
        QCOMPARE_EQ(asSingle(0.5), 0.5);
    }

    // Eigen is the other hand here: the same bits, for turns of any kind.
    void turnsAsEigenDoes() {
        std::mt19937 random(3);
        std::normal_distribution<double> any;
        for (int i = 0; i < 2000; ++i) {
            const Quat turn = Quat(any(random), any(random), any(random), any(random)).normalized();
            const Vec3 v = std::exp(5 * any(random)) * Vec3(any(random), any(random), any(random));
            const Vec3 ours = rotated(turn, v), theirs = turn * v;
            for (int k = 0; k < 3; ++k)
                QCOMPARE_EQ(ours[k], theirs[k]);
        }
    }
    void turnsOnto_data() {
        QTest::addColumn<double>("near"); // how far from opposite, of any direction; 0: exactly opposite
        QTest::newRow("any") << 10.0;
        QTest::newRow("nearly opposite") << 1e-4;
        QTest::newRow("opposite but for rounding") << 1e-9;
        QTest::newRow("opposite") << 0.0;
    }
    void turnsOnto() {
        QFETCH(double, near);
        std::mt19937 random(7);
        std::normal_distribution<double> any;
        const auto some = [&] { return Vec3(any(random), any(random), any(random)); };
        for (int i = 0; i < 200; ++i) {
            const Vec3 from = 3 * some(), to = -2 * from + near * from.norm() * some();
            const Quat turn = turnOnto(from, to);
            COMPARE_NEAR(turn.norm(), 1, 1e-12, "");
            COMPARE_NEAR(Vec3(turn * from.normalized()), Vec3(to.normalized()), 2e-6, "");
            const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
            COMPARE_NEAR(2 * std::atan2(turn.vec().norm(), turn.w()), angle, 2e-6, "rad");
        }
    }
};

TACTUM_TEST(TestVec)

} // namespace test_vec

#include "test_vec.moc"
