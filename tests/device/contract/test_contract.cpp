// The contract of core/port/haptic_device.h, held against every driver there is.
#include <cmath>
#include <limits>

#include <QTest>

#include "core/port/device_check.h"
#include "tests/device/contract/rigs.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_contract {

using namespace tactum;
using namespace tactum::test;

class TestContract : public QObject {
    Q_OBJECT

    std::unique_ptr<Rig> rig_;

    static void everyDriver() {
        QTest::addColumn<QString>("driver");
        for (const std::string& name : rigNames())
            QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
    void take() {
        QFETCH(QString, driver);
        rig_ = makeRig(driver.toStdString());
    }
    static bool usable(const DeviceSample& sample) {
        return sample.valid && sample.position.allFinite() && sample.velocity.allFinite();
    }
    /// Exchanges until it is so.
    bool until(const Vec3& force, const std::function<bool(const DeviceSample&)>& isSo) const {
        for (Patience patience; !patience.isOver();)
            if (isSo(rig_->exchange(force))) return true;
        return false;
    }
    bool reads() const { return until(Vec3::Zero(), usable); }
    bool isFree() const { return !rig_->pushed() || rig_->pushed()->norm() < 1e-6; }
    /// A newton along an axis that it has a motor for.
    Vec3 newton() const {
        int axis = 2;
        while (!rig_->pushesAlong(axis))
            --axis;
        return Vec3::Unit(axis);
    }
    bool pushes() const {
        return until(newton(), [&](const DeviceSample& sample) { return usable(sample) && !isFree(); });
    }
    static bool isOneLine(const std::string& text) {
        return text.size() > 20 && text.find('\n') == std::string::npos;
    }

private slots:
    void cleanup() { rig_.reset(); }

    void itsFiguresArePossible_data() { everyDriver(); }
    void itsFiguresArePossible() {
        take();
        VERIFY_RESULT(checkDevice(rig_->device().info()));
        QVERIFY(!rig_->device().info().name.empty());
    }

    void closedItReadsNothingAndPushesNobody_data() { everyDriver(); }
    void closedItReadsNothingAndPushesNobody() {
        take();
        if (!rig_->pushed()) QSKIP("a hand of our own");
        for (int i = 0; i < 20; ++i) {
            QVERIFY(!rig_->exchange(newton()).valid);
            QVERIFY(isFree());
        }
    }

    void openedItReadsAndIsFree_data() { everyDriver(); }
    void openedItReadsAndIsFree() {
        take();
        VERIFY_RESULT(rig_->open());
        QVERIFY(isFree());
        QVERIFY(reads());
        QVERIFY(isFree());
        QCOMPARE(rig_->device().trouble(), std::string());
        VERIFY_RESULT(checkDevice(rig_->device().info())); // which may be other ones now
    }

    void noForceIsAboveTheLimitOrNoNumber_data() { everyDriver(); }
    void noForceIsAboveTheLimitOrNoNumber() {
        take();
        if (!rig_->pushed()) QSKIP("nobody is pushed");
        VERIFY_RESULT(rig_->open());
        QVERIFY(reads());
        const double inf = std::numeric_limits<double>::infinity(), limit = rig_->device().info().maxForce;
        double strongest = 0;
        for (const Vec3& wild : {Vec3(0, 0, 100), Vec3(0, -1e300, 1e300), Vec3(std::nan(""), 1, 0),
                                 Vec3(inf, 0, 0), Vec3(limit, limit, limit)})
            for (int i = 0; i < 30; ++i) {
                rig_->exchange(wild);
                const Vec3 pushed = *rig_->pushed();
                QVERIFY(pushed.allFinite());
                strongest = std::max(strongest, pushed.norm());
            }
        QCOMPARE_LE(strongest, 1.02 * limit); // a motor command is a whole number
        QCOMPARE_GT(strongest, 0.4 * limit);
    }

    void itPushesAlongTheAxisThatItIsAskedFor_data() { everyDriver(); }
    void itPushesAlongTheAxisThatItIsAskedFor() {
        take();
        if (!rig_->pushed() || QByteArray(QTest::currentDataTag()) == "in another process")
            QSKIP("not seen on the bench");
        VERIFY_RESULT(rig_->open());
        QVERIFY(reads());
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) {
                if (!rig_->pushesAlong(axis)) continue;
                const Vec3 wanted =
                    sign * std::min(1.0, 0.8 * rig_->device().info().maxForce) * Vec3::Unit(axis);
                const auto there = [&](const DeviceSample&) {
                    return (*rig_->pushed() - wanted).norm() < 0.1;
                };
                QVERIFY2(until(wanted, there), qPrintable(QString::number(axis)));
            }
    }

    void closingSetsItFree_data() { everyDriver(); }
    void closingSetsItFree() {
        take();
        VERIFY_RESULT(rig_->open());
        QVERIFY(!rig_->pushed() || pushes());
        rig_->device().close();
        QVERIFY(eventually([&] { return isFree(); }));
        rig_->device().close(); // safe
        VERIFY_RESULT(rig_->open());
        QVERIFY(reads());
        QVERIFY(isFree()); // what was asked for before counts for nothing
    }

    void whoDestroysItOpenSetsItFree_data() { everyDriver(); }
    void whoDestroysItOpenSetsItFree() {
        take();
        VERIFY_RESULT(rig_->open());
        QVERIFY(!rig_->pushed() || pushes());
        rig_->destroyDevice();
        QVERIFY(eventually([&] { return isFree(); }));
    }

    void anEmergencySetsItFree_data() { everyDriver(); }
    void anEmergencySetsItFree() {
        take();
        if (!rig_->pushed() || !rig_->stops()) QSKIP("there is no way to it");
        VERIFY_RESULT(rig_->open());
        QVERIFY(pushes());
        QVERIFY(eventually([&] {
            rig_->device().emergencyStop(); // an emulated bus goes on only when somebody looks
            return isFree();
        }));
    }

    void pulledOutItSaysSoAndComesBack_data() { everyDriver(); }
    void pulledOutItSaysSoAndComesBack() {
        take();
        VERIFY_RESULT(rig_->open());
        QVERIFY(reads());
        if (!rig_->pull()) QSKIP("no cable");
        QVERIFY(until(newton(), [](const DeviceSample& sample) { return !usable(sample); }));
        QVERIFY(until(newton(), [&](const DeviceSample&) { return !rig_->device().trouble().empty(); }));
        QVERIFY2(isOneLine(rig_->device().trouble()), rig_->device().trouble().c_str());
        rig_->device().close();
        const Result<void> gone = rig_->open();
        QVERIFY(!gone);
        QVERIFY2(isOneLine(gone.error().text), gone.error().text.c_str());
        rig_->plug();
        VERIFY_RESULT(rig_->open());
        QVERIFY(reads());
        QVERIFY(isFree());
        QCOMPARE(rig_->device().trouble(), std::string());
    }
};

TACTUM_TEST(TestContract)

} // namespace test_contract

#include "test_contract.moc"
