// What is remembered of a device, and how its axes are found out.
//
// What would show that a test here is wrong: every figure of the settings is another number; a mapping is one
// of the 48 that checkWorkspace() takes.
#include <QSettings>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/own_folders.h"
#include "ui/engine/axis_capture.h"
#include "ui/engine/device_settings.h"

namespace test_device_memory {

using namespace tactum;

class TestDeviceMemory : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void initTestCase() { useFoldersIn(folder_.path()); }

    void everyDeviceHasSettingsOfItsOwn() {
        DeviceSettings one;
        one.workspace.scale = 2.5;
        one.workspace.axes = {-2, 1, -3};
        one.workspace.offset = Vec3(0.1, -0.2, 0.3);
        one.workspace.clutch = 2;
        one.workspace.bump = true;
        one.stopButton = 4;
        one.grasped = true;
        rememberSettings(QStringLiteral("usb:1/2"), one);
        QVERIFY(rememberedSettings(QStringLiteral("usb:1/2")) == one);
        QVERIFY(rememberedSettings(QStringLiteral("usb:1")) == DeviceSettings());
        QVERIFY(rememberedSettings(QStringLiteral("usb:1/3")) == DeviceSettings());
        rememberSettings(QStringLiteral("usb:1/2"), {});
        QVERIFY(rememberedSettings(QStringLiteral("usb:1/2")) == DeviceSettings());
    }

    // A file that somebody wrote: the workspace that cannot be is left out, the rest stays.
    void whatCannotBeIsLeftOut_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QVariant>("value");
        QTest::newRow("no scale") << "scale" << QVariant(0.0);
        QTest::newRow("no number") << "scale" << QVariant(QStringLiteral("nan"));
        QTest::newRow("an axis twice") << "axes" << QVariant(QStringList{"1", "1", "3"});
        QTest::newRow("no axes") << "axes" << QVariant(QStringList{"a", "b", "c"});
        QTest::newRow("far away") << "x" << QVariant(QStringLiteral("inf"));
    }

    void whatCannotBeIsLeftOut() {
        QFETCH(QString, key);
        QFETCH(QVariant, value);
        DeviceSettings settings;
        settings.workspace.scale = 3;
        settings.stopButton = 2;
        rememberSettings(QStringLiteral("arm"), settings);
        QSettings stored;
        stored.setValue(QStringLiteral("device/of/arm/") + key, value);
        const DeviceSettings now = rememberedSettings(QStringLiteral("arm"));
        QVERIFY(now.workspace == Workspace());
        QCOMPARE(now.stopButton, 2u);
        stored.setValue(QStringLiteral("device/of/arm/axes"),
                        QStringList{"1", "2"}); // cut off: the usual ones
        stored.setValue(QStringLiteral("device/of/arm/scale"), 3);
        stored.setValue(QStringLiteral("device/of/arm/x"), 0);
        QVERIFY(rememberedSettings(QStringLiteral("arm")).workspace == settings.workspace);
    }

    void howFarAHandleReaches() {
        DeviceInfo device;
        QCOMPARE_EQ(usualRadius(device), 0.05);
        device.workspaceRadius = 0.2;
        QCOMPARE_EQ(usualRadius(device), 0.2);
    }

    void everyMappingThatCanBeChosenIsPossible() {
        QCOMPARE(withAxis(kSameAxes, 0, -3), (AxisMap{-3, 2, 1}));
        QCOMPARE(withAxis({-3, 2, 1}, 1, 3), (AxisMap{2, 3, 1}));
        QCOMPARE(withAxis(kSameAxes, 2, -3), (AxisMap{1, 2, -3}));
        for (int first : {1, -1, 2, -2, 3, -3})
            for (std::size_t which = 0; which < 3; ++which)
                for (int axis : {1, -1, 2, -2, 3, -3}) {
                    const AxisMap axes = withAxis(withAxis(kSameAxes, 1, first), which, axis);
                    VERIFY_RESULT(checkWorkspace({.axes = axes}));
                    QCOMPARE_EQ(axes[which], axis);
                }
    }

    // The handle goes along each of the device's axes, both ways, in every order.
    void threeMotionsAreAMapping() {
        std::array<int, 3> order{0, 1, 2};
        do {
            for (int signs = 0; signs < 8; ++signs) {
                AxisCapture capture(0.02);
                Vec3 at(0.5, -0.3, 0.1);
                AxisMap expected{};
                QVERIFY(!capture.add(at));
                for (std::size_t step = 0; step < 3; ++step) {
                    QCOMPARE(capture.step(), step);
                    QVERIFY(!capture.complete());
                    const int axis = order[step], sign = signs >> step & 1 ? -1 : 1;
                    expected[step] = std::int8_t(sign * (axis + 1));
                    QVERIFY(!capture.add(at)); // where it starts
                    at[axis] += sign * 0.0199;
                    QVERIFY(!capture.add(at));
                    QCOMPARE_GT(capture.progress(), 0.99);
                    at[axis] += sign * 0.0002;
                    QVERIFY(capture.add(at));
                    QCOMPARE_EQ(capture.progress(), 0);
                }
                QVERIFY(capture.complete());
                QVERIFY(capture.axes() == expected);
                QVERIFY(!capture.add(at + Vec3::Constant(1))); // nothing is asked for any more
            }
        } while (std::next_permutation(order.begin(), order.end()));
    }

    void motionsThatAreNotClearDoNot() {
        AxisCapture capture(0.02);
        QVERIFY(!capture.add({0.5, 0, 0})); // where it is does not matter
        QVERIFY(!capture.add({0.515, 0, 0}));
        QCOMPARE(std::round(100 * capture.progress()), 75.0);
        QVERIFY(!capture.add({0.53, 0.03, 0})); // askew
        QVERIFY(!capture.add(Vec3::Constant(std::nan(""))));
        QVERIFY(capture.add({0.53, 0.01, 0}));
        QCOMPARE(capture.step(), std::size_t(1));
    }

    // Half as far along another one is clear enough; an axis that is taken does not disturb.
    void whatIsClear() {
        AxisCapture capture(0.02);
        QVERIFY(!capture.add(Vec3::Zero()));
        QVERIFY(!capture.add(Vec3(0.0401, 0, 0.0201)));
        QVERIFY(capture.add(Vec3(0.0401, 0, -0.02)));
        QVERIFY(!capture.add(Vec3::Zero()));
        QVERIFY(!capture.add(Vec3(5, 0, 0)));
        QVERIFY(capture.add(Vec3(5, -0.03, 0.01)));
        QVERIFY(!capture.complete());
        QVERIFY(!capture.add(Vec3::Zero()));
        QVERIFY(capture.add(Vec3(-5, 7, 0.021)));
        QCOMPARE(capture.axes(), (AxisMap{1, -2, 3}));
    }
};

TACTUM_TEST(TestDeviceMemory)

} // namespace test_device_memory

#include "test_device_memory.moc"
