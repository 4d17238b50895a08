// Haply's Inverse3 against a service that stands in for Haply's: axes, limits, and everything that can be
// missing.
#include <cmath>
#include <limits>
#include <optional>

#include <QTest>

#include "device/vendor/haply_inverse3.h"
#include "device/vendor/haply_messages.h"
#include "tests/device/vendor/fake_haply.h"
#include "tests/device/vendor/hand.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"

namespace test_haply_inverse3 {

using namespace tactum;
using namespace tactum::test;

class TestHaplyInverse3 : public QObject {
    Q_OBJECT

    std::optional<FakeHaply> service_;

    static std::unique_ptr<HapticDevice> device(const std::string& id = "haply:049D") {
        auto made = makeHaply(id, {.name = "", .maxForce = 8, .rate = 1000, .buttons = 3});
        return made ? std::move(*made) : nullptr;
    }
    static std::unique_ptr<HapticDevice> opened() {
        auto made = device();
        if (const auto ok = made->open(); !ok) qWarning("%s", ok.error().text.c_str());
        return made;
    }
    Vec3 motors() const { return {service_->motors[0], service_->motors[1], service_->motors[2]}; }

private slots:
    void init() {
        service_.emplace();
        qputenv("TACTUM_HAPLY_PORT", QByteArray::number(service_->port()));
    }
    void cleanup() {
        QCOMPARE(service_->misuses.load(), 0);
        QCOMPARE(service_->notFinite.load(), 0);
        QCOMPARE(service_->notUnderstood.load(), 0);
        service_.reset();
    }

    /// Theirs: x right, y forward, z up. Ours: x right, y up, z toward the user.
    void readingsComeInOurFrame() {
        service_->position[0] = 0.01;
        service_->position[1] = 0.02;
        service_->position[2] = 0.03;
        service_->velocity[1] = 0.5;
        service_->button = true;
        const auto device = opened();
        Hand hand(*device);
        QVERIFY(hand.until([&] { return hand.last.valid; }));
        COMPARE_NEAR(hand.last.position, Vec3(0.01, 0.03, -0.02), 1e-12, "m");
        COMPARE_NEAR(hand.last.velocity, Vec3(0, 0, -0.5), 1e-12, "m/s");
        QCOMPARE(hand.last.buttons, 2u);
        QVERIFY(device->trouble().empty());
        QCOMPARE(device->info().delay, 1.0);
        QCOMPARE(service_->greetings.load(), 1); // only with the first message
    }

    void forcesArriveInTheirs() {
        const auto device = opened();
        Hand hand(*device, {1, 2, 3});
        QVERIFY(hand.until([&] { return (motors() - Vec3(1, -3, 2)).isZero(); }));
    }

    /// docs.haply.co 3.5: "vector", a preset is an object. Programs for 3.1 say "values" and its bare name.
    void eachVersionHearsItsOwnWords_data() {
        QTest::addColumn<int>("minor");
        QTest::newRow("3.5") << 5;
        QTest::newRow("3.1") << 1;
        QTest::newRow("3.9") << 9;
    }

    void eachVersionHearsItsOwnWords() {
        QFETCH(int, minor);
        service_->minor = minor;
        service_->position[0] = 0.01;
        const auto device = opened();
        Hand hand(*device, {1, 2, 3});
        QVERIFY(hand.until([&] { return (motors() - Vec3(1, -3, 2)).isZero() && hand.last.valid; }));
        QVERIFY(service_->centered);
        COMPARE_NEAR(hand.last.position, Vec3(0.01, 0, 0), 1e-12, "m"); // about the origin
        QVERIFY(device->caution().empty());
    }

    void whatTheVersionPageSays() {
        QVERIFY((haply::versionOf(R"({"git_tag":"3.1.1"})") == haply::Version{3, 1}));
        QVERIFY((haply::versionOf(R"({"project_version":"4.0.0.0"})") == haply::Version{4, 0}));
        for (const char* nothing : {"", "{", "[]", R"({"git_tag":7})", R"({"git_tag":"main"})"})
            QVERIFY((haply::versionOf(nothing) == haply::kNewWords));
    }

    void aWorkspaceThatIsNotTakenIsSaid() {
        service_->keepsPreset = true;
        const auto result = device()->open();
        QVERIFY(!result);
        COMPARE_CONTAINS(result.error().text, "arm_front_centered");
        COMPARE_CONTAINS(result.error().text, "defaults");
        service_->keepsPreset = false;
        VERIFY_RESULT(device()->open());
    }

    void forcesThatAreNotPassedOnAreSaid() {
        service_->passesForces = false;
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return !device->caution().empty(); }));
        COMPARE_CONTAINS(device->caution(), "switched off");
        service_->passesForces = true;
        QVERIFY(hand.until([&] { return device->caution().empty(); }));
    }

    void theAxesOfForceAndPositionAgree() {
        const auto device = opened();
        for (int axis = 0; axis < 3; ++axis) {
            Hand hand(*device, Vec3::Unit(axis));
            QVERIFY(hand.until([&] { return motors().norm() > 0.9 && hand.last.valid; }));
            hand.forTicks(20);
            for (std::size_t i = 0; i < 3; ++i)
                service_->position[i] = 0.01 * service_->motors[i];
            QVERIFY(hand.until([&] { return (hand.last.position - 0.01 * Vec3::Unit(axis)).isZero(1e-9); }));
        }
    }

    void noForceIsAboveTheLimitOrNoNumber() {
        const auto device = opened();
        const double inf = std::numeric_limits<double>::infinity();
        for (const Vec3& wild : {Vec3(100, 0, 0), Vec3(0, -1e300, 1e300), Vec3(std::nan(""), 1, 0),
                                 Vec3(inf, 0, 0), Vec3(0, 0, -inf)})
            Hand(*device, wild).forTicks(30);
        QCOMPARE_LE(service_->strongest, 8 + 1e-9);
        QCOMPARE_GT(service_->strongest, 7.9);
    }

    void whatCannotBeReadIsNoReading_data() {
        QTest::addColumn<QByteArray>("answer");
        const char* answers[] = {
            R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0.1,"y":0.1}}}]})",
            R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0.1,"y":0.1,"z":null}}}]})",
            R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":"0","y":0,"z":0}}}]})",
            R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":1e300,"y":0,"z":0}}}]})",
            R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":[0,0,0]}}]})",
            R"({"inverse3":[{"device_id":"049D","state":[]}]})",
            R"({"inverse3":[{"device_id":"049D"}]})",
            R"({"inverse3":[5,null,{"device_id":"049D"},{"device_id":7}]})",
        };
        for (const char* answer : answers)
            QTest::newRow(answer) << QByteArray(answer);
    }

    void whatCannotBeReadIsNoReading() {
        QFETCH(QByteArray, answer);
        const auto device = opened();
        Hand hand(*device);
        QVERIFY(hand.until([&] { return hand.last.valid; }));
        service_->setAnswer(answer.toStdString());
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        QVERIFY(hand.until([&] { return !device->trouble().empty(); }));
        service_->setAnswer({});
        QVERIFY(hand.until([&] { return hand.last.valid; }));
        QVERIFY(hand.until([&] { return device->trouble().empty(); }));
    }

    void nonsenseIsNoDevice() {
        for (const char* text :
             {"", "{", "[]", "5", "null", "\xff\xfe", "{\"inverse3\":{}}", "{\"inverse3\":5}"})
            QVERIFY2(haply::read(text).empty(), text);
        QVERIFY(haply::read(std::string(100'000, '[')).empty());
    }

    void unpluggedItGivesNoReadingsAndSaysSo() {
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return hand.last.valid && motors().x() == 1; }));
        service_->present = false;
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        COMPARE_CONTAINS(device->trouble(), "cable");
        QVERIFY(!device->open());
        service_->present = true;
        Watcher watcher;
        VERIFY_RESULT(device->prepare(watcher)); // begun anew
        QVERIFY(device->trouble().empty());
        VERIFY_RESULT(device->open());
        QVERIFY(hand.until([&] { return hand.last.valid; }));
        QVERIFY(device->trouble().empty());
    }

    void aServiceThatEndsIsSaid() {
        const auto device = opened();
        Hand hand(*device);
        QVERIFY(hand.until([&] { return hand.last.valid; }));
        service_->stop();
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        QVERIFY(hand.until([&] { return device->trouble().find("does not answer") != std::string::npos; }));
    }

    void aServiceThatFallsSilentIsSaid() {
        const auto device = opened();
        Hand hand(*device);
        QVERIFY(hand.until([&] { return hand.last.valid; }));
        service_->silent = true;
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        QVERIFY(hand.until([&] { return !device->trouble().empty(); }));
    }

    void aServoThatStandsStillLosesItsForce() {
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        QVERIFY(test::waitFor([&] { return motors().isZero(); }));
    }

    void theDeviceWatchdogStopsItAtOnce() {
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        device->emergencyStop();
        const int heard = service_->heard;
        QVERIFY(test::waitFor([&] { return service_->heard >= heard + 2; }));
        QVERIFY(motors().isZero());
    }

    void closeSendsZero() {
        auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        device->close();
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QVERIFY(device->trouble().empty());
        VERIFY_RESULT(device->open());
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        device.reset();
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
    }

    void preparedItGivesNoForceYet() {
        const auto made = device();
        Watcher watcher;
        VERIFY_RESULT(made->prepare(watcher));
        Hand hand(*made, {1, 0, 0});
        hand.forTicks(20);
        QVERIFY(!hand.last.valid);
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QVERIFY(watcher.steps == made->steps());
    }

    void calibrationIsAskedForAndWaitedFor() {
        service_->calibrated = false;
        const auto made = device();
        QVERIFY(!made->open()); // nobody is at hand
        Watcher watcher;
        watcher.onRequest = [&](std::string_view) { service_->calibrated = true; };
        VERIFY_RESULT(made->prepare(watcher));
        QVERIFY(!watcher.request.empty());
    }

    void withoutTheServiceThereIsASentence() {
        service_->stop();
        const auto listings = listHaply();
        QCOMPARE(listings.size(), std::size_t(1));
        QVERIFY(!listings.front().usable);
        QVERIFY(listings.front().id.empty());
        for (const char* word : {"Inverse Service", "install", "TACTUM_HAPLY_PORT"})
            COMPARE_CONTAINS(listings.front().sentence, word);
        QVERIFY(!device()->open());
    }

    void whatIsConnectedIsListed() {
        const auto listings = listHaply();
        QCOMPARE(listings.size(), std::size_t(1));
        QCOMPARE(listings.front().id, std::string("haply:049D"));
        QVERIFY(listings.front().usable);
        service_->present = false;
        QVERIFY(!listHaply().front().usable);
        service_->silent = true;
        QVERIFY(!listHaply().front().usable);
    }

    void anotherIdIsSaid() {
        const auto result = device("haply:FFFF")->open();
        QVERIFY(!result);
        COMPARE_CONTAINS(result.error().text, "FFFF");
        QVERIFY(!makeHaply("haply:", {}));
        QVERIFY(!makeHaply("falcon:1", {}));
    }
};

TACTUM_TEST(TestHaplyInverse3)

} // namespace test_haply_inverse3

#include "test_haply_inverse3.moc"
