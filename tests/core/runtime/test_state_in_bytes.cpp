// A state as bytes: how much room the fullest one takes, and what is no state of a World.
#include <QTest>

#include "core/haptics/compile.h"
#include "core/runtime/recorded_step.h"
#include "core/runtime/state_bytes.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_state_in_bytes {

using namespace tactum;

namespace {

/// As much as there can be at once.
SimState fullest() {
    SimState state;
    state.proxy.contactCount = int(state.proxy.contacts.size());
    state.proxy.feltCount = int(state.proxy.felt.size());
    state.proxy.passedCount = int(state.proxy.passed.size());
    state.proxy.straddledCount = int(state.proxy.straddled.size());
    state.time = 12.5;
    return state;
}

std::shared_ptr<const World> twoTriangles() {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    soup->triangles = {{0, 1, 2}, {1, 3, 2}};
    soup->surfaceOf = {0, 0};
    Scene scene;
    SceneObject object;
    object.geometry = soup;
    object.surfaces.resize(1);
    scene.add(object);
    scene.add(object);
    return compile(scene).value();
}

} // namespace

class TestStateInBytes : public QObject {
    Q_OBJECT

private slots:
    void theFullestStateHasRoom() {
        SimStateBytes bytes;
        write(fullest(), bytes);
        QCOMPARE_GT(bytes.size, 0u);
        QCOMPARE_LE(bytes.size, bytes.bytes.size());
        SimState back;
        QVERIFY(read(bytes.used(), back));
        QCOMPARE(back.time, 12.5);
        QCOMPARE(back.proxy.contactCount, fullest().proxy.contactCount);
        QCOMPARE(back.proxy.straddledCount, fullest().proxy.straddledCount);
        ServoStateBytes servo;
        write(ServoState(DeviceInfo()), servo);
        QCOMPARE_GT(servo.size, 0u);
        QCOMPARE_LE(servo.size, servo.bytes.size());
    }

    void whatIsCutOrLongerIsRefused() {
        SimStateBytes bytes;
        write(fullest(), bytes);
        for (const std::size_t length : {std::size_t(0), std::size_t(1), std::size_t(bytes.size - 1)}) {
            SimState state;
            QVERIFY(!read(bytes.used().first(length), state));
        }
        SimState state;
        QVERIFY(!read(std::span<const std::byte>(bytes.bytes).first(bytes.size + 1), state));
        ServoStateBytes servo;
        write(ServoState(DeviceInfo()), servo);
        ServoState other{DeviceInfo()};
        QVERIFY(read(servo.used(), other));
        QVERIFY(!read(servo.used().first(servo.size - 1), other));
    }

    void whatAStateNamesExistsInItsWorld() {
        const auto world = twoTriangles();
        QCOMPARE(world->obstacles.size(), 2u);
        const auto belongs = [&](auto change) {
            SimState state;
            change(state.proxy);
            return belongsTo(state, *world);
        };
        QVERIFY(belongs([](ProxyState&) {}));
        QVERIFY(belongs(
            [](ProxyState& p) { p.contactCount = 1, p.contacts[0].body = 1, p.contacts[0].triangle = 1; }));
        QVERIFY(!belongs([](ProxyState& p) { p.contactCount = 1, p.contacts[0].body = 2; }));
        QVERIFY(!belongs([](ProxyState& p) { p.contactCount = 1, p.contacts[0].triangle = 2; }));
        QVERIFY(!belongs([](ProxyState& p) { p.contactCount = 2, p.contacts[1].triangle = 2; }));
        QVERIFY(
            belongs([](ProxyState& p) { p.contactCount = 1, p.contacts[1].triangle = 2; })); // not counted
        QVERIFY(belongs([](ProxyState& p) { p.feltCount = 1, p.felt[0].body = 1, p.felt[0].triangle = 1; }));
        QVERIFY(!belongs([](ProxyState& p) { p.feltCount = 1, p.felt[0].body = 2; }));
        QVERIFY(!belongs([](ProxyState& p) { p.feltCount = 1, p.felt[0].triangle = 2; }));
        QVERIFY(belongs([](ProxyState& p) { p.passedCount = 1, p.passed[0].body = 1; }));
        QVERIFY(!belongs([](ProxyState& p) { p.passedCount = 1, p.passed[0].body = 2; }));
        QVERIFY(belongs([](ProxyState& p) { p.straddledCount = 1, p.straddled[0].body = 1; }));
        QVERIFY(!belongs([](ProxyState& p) { p.straddledCount = 1, p.straddled[0].body = 2; }));
    }

    /// Recordings that lie on disks have these bits.
    void flagsOfRowsStay() {
        std::uint32_t bit = 1;
        for (const auto flag : {ProxyRow::Restart, ProxyRow::Forget, ProxyRow::Found, ProxyRow::Absent}) {
            QCOMPARE(std::uint32_t(flag), bit);
            bit *= 2;
        }
        QCOMPARE(std::uint32_t(ProxyRow::kFidelity), 8u);
        QCOMPARE(std::uint32_t(ProxyRow::kAllFlags), 0x31fu);
        bit = 1;
        for (const auto flag : {ServoRow::Valid, ServoRow::Jumped, ServoRow::Late, ServoRow::Fresh,
                                ServoRow::Armed, ServoRow::Override, ServoRow::Unguarded, ServoRow::Clutched,
                                ServoRow::Stopped, ServoRow::Fading, ServoRow::Grasped}) {
            QCOMPARE(std::uint32_t(flag), bit);
            bit *= 2;
        }
        QCOMPARE(std::uint32_t(ServoRow::kAllFlags), bit - 1);
    }
};

TACTUM_TEST(TestStateInBytes)

} // namespace test_state_in_bytes

#include "test_state_in_bytes.moc"
