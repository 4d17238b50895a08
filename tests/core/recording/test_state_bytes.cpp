// A state that was written and read back goes on as the one that was written: nothing that matters is left
// out.
#include <cmath>
#include <memory>

#include <QTest>

#include "core/haptics/compile.h"
#include "core/runtime/recorded_step.h"
#include "core/runtime/state_bytes.h"
#include "tests/realtime/bumpy_scene.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_state_bytes {

using namespace tactum;

namespace {

constexpr double kTick = 1e-3;
constexpr int kEvery = 20; ///< ticks, after which the copy is made anew

DeviceInfo device() {
    return {.name = "Hand-made", .maxForce = 8, .rate = 1000, .damping = 1e5, .tripSpeed = 20};
}

bool sameBits(const Vec3& a, const Vec3& b) {
    return a == b && std::signbit(a.x()) == std::signbit(b.x());
}

template <class State, std::size_t Room>
std::unique_ptr<State> copyOf(const State& state, StateBytes<Room>&& bytes) {
    write(state, bytes);
    auto copy = std::make_unique<State>(state);
    if constexpr (std::is_same_v<State, SimState>)
        *copy = {};
    else
        *copy = ServoState(device());
    if (bytes.size == 0 || !read(bytes.used(), *copy)) return nullptr;
    return copy;
}

/// Strokes, rests (where steps depend on those before the most) and shakes in turn.
Vec3 fingerAt(int tick) {
    const int phase = tick / 150 % 3, rest = tick - tick % 150;
    if (phase == 1) return wanderingFinger(4 * kTick * rest);
    if (phase == 2) return wanderingFinger(4 * kTick * rest) + Vec3(0, 0, 4e-4 * std::sin(0.7 * tick));
    return wanderingFinger(4 * kTick * tick);
}

} // namespace

class TestStateBytes : public QObject {
    Q_OBJECT

private slots:
    void whatIsReadBackGoesOnTheSame() {
        const auto plate = bumpyPlate(1);
        std::shared_ptr<const World> world = compile(bumpyScene(plate, 0)).value();
        SimState sim;
        ServoState servo(device());
        std::unique_ptr<SimState> otherSim;
        std::unique_ptr<ServoState> otherServo;
        int touching = 0;
        for (int tick = 0; tick < 12'000; ++tick) {
            if (tick % 400 == 399) world = compile(bumpyScene(plate, tick / 400), world.get()).value();
            if (tick % kEvery == 0) {
                sim.proxy.memories = {}; // as the loop does whenever it keeps a state
                otherSim = copyOf(sim, SimStateBytes{});
                otherServo = copyOf(servo, ServoStateBytes{});
                QVERIFY(otherSim);
                QVERIFY(otherServo);
            }
            const Vec3 finger = fingerAt(tick), velocity = (finger - fingerAt(tick - 1)) / kTick;
            const ProxyRow row{.dt = kTick, .finger = tripleOf(finger), .velocity = tripleOf(velocity)};
            const HapticOutput one = stepFrom(row, *world, sim), other = stepFrom(row, *world, *otherSim);
            QVERIFY2(sameBits(one.proxy, other.proxy) && sameBits(one.force, other.force) &&
                         one.contacts == other.contacts,
                     qPrintable(QStringLiteral("haptic step %1").arg(tick)));
            touching += one.contacts > 0;
            LocalContactModel model = sim.model;
            model.anchoring = servo.gate.anchoring();
            const ServoRow input{.dt = kTick,
                                 .apart = kTick,
                                 .position = tripleOf(finger),
                                 .velocity = tripleOf(velocity),
                                 .flags = ServoRow::Valid | ServoRow::Fresh |
                                          (tick % 3000 < 2800 ? ServoRow::Armed : 0u)};
            const Vec3 force = stepFrom(input, servo, model).force;
            QVERIFY2(sameBits(force, stepFrom(input, *otherServo, model).force),
                     qPrintable(QStringLiteral("servo tick %1").arg(tick)));
        }
        QCOMPARE_GT(touching, 4000);
        QCOMPARE_GT(servo.schedule.oscillations(), 0); // the shaking was noticed
    }

    void damagedStatesAreRefused() {
        SimStateBytes bytes;
        write(SimState{}, bytes);
        SimState state;
        QVERIFY(read(bytes.used(), state));
        QVERIFY(!read(bytes.used().first(bytes.size - 1), state)); // too short
        ++bytes.size;
        QVERIFY(!read(bytes.used(), state)); // too long
        --bytes.size;
        bytes.bytes[48] = std::byte(200); // after two points: the number of contacts
        QVERIFY(!read(bytes.used(), state));
    }
};

TACTUM_TEST(TestStateBytes)

} // namespace test_state_bytes

#include "test_state_bytes.moc"
