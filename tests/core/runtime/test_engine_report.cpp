// What an engine tells as bytes: everything comes back, and no bytes of a stranger are believed further than
// they go.
#include <random>

#include <QTest>

#include "core/runtime/engine_report.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_engine_report {

using namespace tactum;

namespace {

/// No value at its initial one.
EngineReport full() {
    EngineReport report;
    report.hands.resize(2);
    HandReport& hand = report.hands[1];
    report.hands[0].device.name = "Beside";
    hand.device.name = "Hand";
    hand.device.maxForce = 7;
    hand.device.buttons = 3;
    hand.device.real = hand.device.measuresVelocity = true;
    report.running = hand.standsStill = report.realtime = true;
    hand.armed = hand.deadMan = hand.overridesCeiling = true;
    report.pace = 0.5;
    hand.workspace = {2, {3, -1, 2}, {1, 2, 3}, 4, true, {ReachMode::Rate, 0.02}, 5};
    report.publishedAfter = 6;
    hand.trouble = "t", hand.caution = "c", report.priorityNote = "p";
    TouchTelemetry& touch = hand.touch;
    touch.output.proxy = {1, 2, 3};
    touch.output.force = {4, 5, 6};
    touch.output.contacts = 2;
    touch.output.contact[1] = {{7, 8, 9}, {0, 1, 0}, 10, 11, 12, true, true, 0.5, 0.25};
    touch.output.report = {13, true, true, true};
    touch.finger = {14, 15, 16};
    WorldTelemetry& proxy = report.world;
    proxy.updates = 17, proxy.worldRevision = 18, proxy.worldSince = 19;
    proxy.rate = 20, proxy.updateMicros = 21, proxy.worstUpdateMicros = 22;
    proxy.boundHits = 23, proxy.squeezed = 24, proxy.passed = 25, proxy.time = 26;
    proxy.bodies.of = 27, proxy.bodies.qs = 2, proxy.bodies.vs = 1;
    proxy.bodies.q[1] = 28, proxy.bodies.v[0] = 29;
    proxy.fidelity = Fidelity::NoShading;
    proxy.stepsDown = 30;
    ServoTelemetry& servo = hand.servo;
    servo.finger = {31, 32, 33}, servo.force = {34, 35, 36}, servo.handle_D = {37, 38, 39};
    servo.frame = {40, {-3, 2, 1}, {41, 42, 43}};
    servo.buttons = 44, servo.ticks = 45, servo.rate = 46, servo.jitterMicros = 47, servo.misses = 48;
    servo.machineMisses = 49, servo.periods.count[3] = 50, servo.periods.longest = 75, servo.clamped = 51,
    servo.invalidSamples = 52;
    servo.inhibit = InhibitReason::Stopped, servo.gain = 0.75, servo.faults = 53, servo.pauses = 54;
    servo.lastPause = InhibitReason::Stall, servo.oscillations = 55, servo.stiffnessScale = 0.5;
    servo.heat = 56, servo.energy = 57, servo.passivityDamping = 58, servo.rendered = 59;
    servo.grasped = servo.doubted = true;
    servo.ceiling = {60, CeilingReason::Maker, 61};
    hand.trace = {{62,
                   {1, 1, 1},
                   {2, 2, 2},
                   {3, 3, 3},
                   {4, 4, 4},
                   63,
                   true,
                   64,
                   65,
                   0.25,
                   true,
                   66,
                   {2, 67, 68, ContactFriction::Slip}},
                  {}};
    return report;
}

} // namespace

class TestEngineReport : public QObject {
    Q_OBJECT

private slots:
    /// Byte by byte: had a member been left out of both directions, one of the values below would be its
    /// initial one.
    void itComesBack() {
        const std::string bytes = bytesOf(full());
        const auto read = readReport(bytes);
        VERIFY_RESULT(read);
        QCOMPARE(bytesOf(*read), bytes);
        QCOMPARE(read->hands.size(), 2u);
        QCOMPARE(read->hands[0].device.name, std::string("Beside"));
        const HandReport& hand = read->hands[1];
        QCOMPARE(hand.device.name, std::string("Hand"));
        QCOMPARE(hand.device.maxForce, 7.0);
        QCOMPARE(hand.workspace.axes, (AxisMap{3, -1, 2}));
        QCOMPARE(hand.workspace.reach, (Reach{ReachMode::Rate, 0.02}));
        QCOMPARE(hand.touch.output.contact[1].staticFriction, 0.5);
        QCOMPARE(hand.touch.output.contact[1].body, 11u);
        QCOMPARE(hand.touch.output.report.passed, true);
        QCOMPARE(read->world.bodies.q[1], 28.0);
        QCOMPARE(read->world.bodies.v[0], 29.0);
        QCOMPARE(read->world.stepsDown, 30u);
        QCOMPARE(hand.servo.handle_D, Vec3(37, 38, 39));
        QCOMPARE(hand.servo.periods.count[3], 50u);
        QCOMPARE(hand.servo.periods.longest, 75.0);
        QCOMPARE(hand.servo.lastPause, InhibitReason::Stall);
        QCOMPARE(hand.servo.ceiling.damping, 61.0);
        QCOMPARE(hand.trace.size(), 2u);
        QCOMPARE(hand.trace[0].tangentialForce, 65.0);
        QCOMPARE(hand.trace[0].wanted, Vec3(4, 4, 4));
        QCOMPARE(hand.trace[0].revision, 66u);
        QVERIFY((hand.trace[0].touched == TouchedPlace{2, 67, 68, ContactFriction::Slip}));
        QCOMPARE(read->priorityNote, std::string("p"));
    }

    /// A byte of each value is changed once: each is either refused, or another report that can be used.
    void everyByteIsInIt() {
        const std::string bytes = bytesOf(full());
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            std::string changed = bytes;
            changed[i] = char(changed[i] ^ 1);
            const auto read = readReport(changed);
            if (read) QVERIFY2(bytesOf(*read) != bytes, qPrintable(QString::number(i)));
        }
    }

    void cutsAndNonsenseAreRefused() {
        const std::string bytes = bytesOf(full());
        for (std::size_t length = 0; length < bytes.size(); ++length)
            QVERIFY(!readReport(std::string_view(bytes).substr(0, length)));
        QVERIFY(!readReport(bytes + '\0'));
        std::mt19937 random(7);
        for (int trial = 0; trial < 20'000; ++trial) {
            std::string changed = bytes;
            for (int n = 1 + int(random() % 8); n > 0; --n)
                changed[random() % changed.size()] = char(random());
            const auto read = readReport(changed);
            if (!read) continue;
            QVERIFY(!read->hands.empty() && read->hands.size() <= std::size_t(kMaxHands));
            QVERIFY(read->world.bodies.qs >= 0 && read->world.bodies.qs <= int(kMaxCoordinates));
            for (const HandReport& hand : read->hands) {
                const HapticOutput& output = hand.touch.output;
                QVERIFY(output.contacts >= 0 && output.contacts <= kMaxModelPlanes);
                QVERIFY(hand.servo.frame.turned({1, 2, 3}).allFinite());
                QVERIFY(std::size_t(hand.servo.inhibit) < kInhibitReasons);
            }
        }
    }

    void anotherVersionIsNamed() {
        std::string bytes = bytesOf(full());
        bytes[0] = 99;
        COMPARE_CONTAINS(readReport(bytes).error().text, "another version");
    }
};

TACTUM_TEST(TestEngineReport)

} // namespace test_engine_report

#include "test_engine_report.moc"
