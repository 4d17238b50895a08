// The driver of the Falcon and the emulated one, through the real libusb: made ready, felt, and with
// everything going wrong that can.
#include <functional>
#include <random>

#include <QTest>
#include <sys/wait.h>
#include <unistd.h>

#include "device/falcon/falcon_preparation.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_falcon {

using namespace tactum;
using namespace tactum::test;

namespace {

using State = EmulatedFalcon::State;

const FalconLegs kNoTorque{};
const Vec3 kPush(0.5, 0.3, 2);

/// To the one that is plugged in, past the driver.
std::unique_ptr<UsbLink> linkTo() {
    const UsbId wanted[] = {kFalconUsb};
    return UsbLink::open(listUsb(wanted).value().at(0), kFalconEndpoints).value();
}

bool isClean() {
    return EmulatedBus::the().openDescriptors() == 0 && EmulatedBus::the().pendingTransfers() == 0;
}

/// A fault, what the test does to bring it and what ends it.
struct Fault {
    const char* name;
    std::function<void(FalconBench&)> begin;
    const char* words; ///< of the trouble that is told
    std::function<void(FalconBench&)> end = [](FalconBench& bench) {
        bench.device->setFaults({});
        EmulatedBus::the().setFaults(kSocket, {});
    };
    bool heard = true;   ///< whether the device still gets commands
    bool repairs = true; ///< whether readings come back when it ends
};

std::function<void(FalconBench&)> inTheDevice(const FalconFaults& faults) {
    return [faults](FalconBench& bench) { bench.device->setFaults(faults); };
}
std::function<void(FalconBench&)> onTheBus(const UsbFaults& faults) {
    return [faults](FalconBench&) { EmulatedBus::the().setFaults(kSocket, faults); };
}

const std::vector<Fault>& faults() {
    constexpr int kMany = 1'000'000;
    static const std::vector<Fault> all{
        {"silent", inTheDevice({.silent = true}), "does not answer"},
        {"every report lacks a byte", inTheDevice({.shortReports = kMany}), "does not answer"},
        {"no report ends as it should", inTheDevice({.wrongEnds = kMany}), "does not answer"},
        {"forgets its home", inTheDevice({.forgetsHome = true}), "pull the grip",
         [](FalconBench& bench) { bench.device->startFirmware(true); }},
        {"an encoder jumps", inTheDevice({.encoderJump = {0, 300, 0}}), "jumped"},
        {"an arm that cannot be", inTheDevice({.encoderJump = {0, 20'000, 0}}), "none can be",
         inTheDevice({.encoderJump = {0, -20'000, 0}})},
        {"no power", [](FalconBench& bench) { bench.device->setPower(false); }, "power supply",
         [](FalconBench& bench) { bench.device->startFirmware(true); }},
        {"reading stalls", onTheBus({.stallIn = true}), "do not hear"},
        {"writing stalls", onTheBus({.stallOut = true}), "do not hear", onTheBus({}), false},
        {"nothing completes", onTheBus({.mute = true}), "", onTheBus({}), false},
    };
    return all;
}

} // namespace

class TestFalcon : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QVERIFY(isClean()); }

    // ---- Made ready.

    void fromPowerToReady() {
        FalconBench bench;
        bench.device->setFaults({.deafTries = 3, .zeroFirst = true});
        const auto falcon = bench.driver();
        Person person(bench.device);
        const auto ready = falcon->prepare(person);
        VERIFY_RESULT(ready);
        QCOMPARE(person.steps, falcon->steps());
        COMPARE_CONTAINS(person.asked, "Pull the grip");
        QCOMPARE(person.most, 1.0);
        QCOMPARE_EQ(bench.device->state(), State::Running);
        QVERIFY(bench.device->homed());
        QCOMPARE(bench.device->uploads(), 1);
        QCOMPARE(bench.device->latency(), 1);
        QCOMPARE(bench.device->torqueCommands(), 0);
        QCOMPARE_EQ(bench.device->light(), FalconLight::Red);
        VERIFY_RESULT(falcon->open());
        QCOMPARE_GT(exchange(*falcon, 50).valid, 40);
        QCOMPARE_EQ(bench.device->light(), FalconLight::Blue);
        QCOMPARE(falcon->trouble(), std::string());
    }

    void whatIsReadyIsNotDoneAgain() {
        FalconBench bench;
        bench.device->startFirmware(true);
        const auto falcon = bench.driver();
        VERIFY_RESULT(falcon->open()); // nobody at hand
        QCOMPARE(bench.device->uploads(), 0);
        falcon->close();
        Person person(bench.device);
        VERIFY_RESULT(falcon->prepare(person));
        QVERIFY(person.asked.empty());
    }

    /// It is asked three times, for the first answer is often lost, and not more often.
    void whetherItIsReadyIsAskedForThreeTimes() {
        FalconBench bench;
        bench.device->startFirmware(true);
        const auto link = linkTo();
        QVERIFY(setFalconLine(*link, kFalconRunLine));
        QVERIFY(isFalconReady(*link));
        for (const int lost : {1, 2}) {
            bench.device->setFaults({.lostReports = lost});
            const int before = bench.device->commands();
            QVERIFY2(isFalconReady(*link), qPrintable(QString("%1 lost").arg(lost)));
            QCOMPARE_GE(bench.device->commands() - before, lost + 1);
        }
        bench.device->setFaults({.silent = true});
        const int before = bench.device->commands();
        QVERIFY(!isFalconReady(*link));
        QVERIFY(hearFalcon(*link, std::chrono::milliseconds(1))); // so that it has heard the last one
        QCOMPARE(bench.device->commands() - before, 3);
        QCOMPARE(bench.device->torqueCommands(), 0);
    }

    void onlyWhoIsHomedIsReady() {
        FalconBench bench;
        const auto link = linkTo();
        QVERIFY(setFalconLine(*link, kFalconRunLine));
        for (const bool homed : {true, false, true}) {
            bench.device->startFirmware(homed);
            QCOMPARE(isFalconReady(*link), homed);
        }
        FalconBench::unplug();
        QVERIFY(!isFalconReady(*link));
    }

    /// It was in use, was left alone, and forgot where its grip is.
    void whatForgotItsHomeIsHomedAnew() {
        FalconBench bench;
        const auto falcon = bench.opened();
        falcon->close();
        bench.device->setFaults({.forgetsHome = true});
        const auto alone = falcon->open();
        COMPARE_CONTAINS(refusal(alone), "\"Home\"");
        COMPARE_CONTAINS(refusal(alone), "somebody at hand");
        Person person(bench.device);
        QVERIFY(falcon->prepare(person));
        COMPARE_CONTAINS(person.asked, "Pull the grip");
        QVERIFY(falcon->open());
        QVERIFY(exchange(*falcon, 50).valid > 40);
        QCOMPARE(bench.device->uploads(), 0);
    }

    /// Loading takes firmware and home away: who may have answered, and was not heard, is asked again before.
    void itIsAskedThreeTimesBeforeItsFirmwareIsReplaced() {
        FalconBench bench;
        bench.device->startFirmware(true);
        bench.device->setFaults({.silent = true});
        const auto falcon = bench.driver();
        Person person(bench.device);
        const auto ready = falcon->prepare(person);
        COMPARE_CONTAINS(refusal(ready), "says nothing");
        QCOMPARE(bench.device->uploads(), 1);
        QCOMPARE(bench.device->commands(), 3 + 3); // before and after
        QCOMPARE(bench.device->torqueCommands(), 0);
    }

    /// Answers are lost now and then while the person homes it, more of them in all than would be in a row.
    void homingBearsLostAnswersButNotSilence() {
        struct Slow final : Person {
            explicit Slow(std::shared_ptr<EmulatedFalcon> device)
                : Person(device), falcon(std::move(device)) {
                homes = false;
            }
            void begin(std::string_view step, std::string_view request) override {
                Person::begin(step, request);
                if (!request.empty()) falcon->setFaults(first);
            }
            void progress(double part) override {
                Person::progress(part);
                if (++heard == 1) falcon->setFaults({.lostReports = 12});
                if (heard == 2) falcon->homeByHand();
            }
            std::shared_ptr<EmulatedFalcon> falcon;
            FalconFaults first;
            int heard = 0;
        };
        FalconBench bench;
        bench.device->startFirmware(false);
        const auto falcon = bench.driver();
        Slow slow(bench.device);
        slow.first = {.lostReports = 12};
        const auto ready = falcon->prepare(slow);
        QVERIFY2(ready, ready ? "" : ready.error().text.c_str());
        QCOMPARE_GE(slow.heard, 2);

        bench.device->startFirmware(false);
        Slow silent(bench.device);
        silent.first = {.silent = true};
        const int before = bench.device->commands();
        const auto never = falcon->prepare(silent);
        COMPARE_CONTAINS(refusal(never), "\"Home\"");
        COMPARE_CONTAINS(refusal(never), "no answer any more");
        QCOMPARE(silent.heard, 0);
        QCOMPARE_LE(bench.device->commands() - before, 20 + 5); // for a second, and before that
    }

    void firmwareIsLoadedUnattendedButHomingNeedsAHand() {
        FalconBench bench;
        const auto falcon = bench.driver();
        const auto opened = falcon->open();
        COMPARE_CONTAINS(refusal(opened), "\"Home\"");
        COMPARE_CONTAINS(refusal(opened), "grip");
        QCOMPARE(bench.device->uploads(), 1);
        QVERIFY(!falcon->exchange({kPush}, 1e-3).valid);
        QCOMPARE(bench.device->torqueCommands(), 0);
    }

    void homingWaitsForThePerson() {
        FalconBench bench;
        bench.device->startFirmware(false);
        const auto falcon = bench.driver();
        Person person(bench.device);
        person.homes = false;
        std::jthread later([&] {
            QTest::qSleep(300);
            person.gaveUp = true;
        });
        COMPARE_CONTAINS(refusal(falcon->prepare(person)), "\"Home\"");
        QCOMPARE_EQ(bench.device->light(), FalconLight::Red);
        QVERIFY(!bench.device->homed());
    }

    void thePersonMayGiveUpAtAnyStep() {
        for (const char* step : {"Firmware", "Home"}) {
            FalconBench bench;
            const auto falcon = bench.driver();
            Person person(bench.device);
            person.givesUpAt = step;
            COMPARE_CONTAINS(refusal(falcon->prepare(person)), step);
            QCOMPARE(person.steps.back(), std::string(step));
            Person patient(bench.device);
            VERIFY_RESULT(falcon->prepare(patient));
        }
    }

    void withoutPowerItSaysSo() {
        FalconBench bench;
        bench.device->setPower(false);
        const auto falcon = bench.driver();
        Person person(bench.device);
        const auto ready = falcon->prepare(person);
        COMPARE_CONTAINS(refusal(ready), "\"Firmware\"");
        COMPARE_CONTAINS(refusal(ready), "power supply");
    }

    void notThereOrNotAllowed() {
        FalconBench bench;
        const auto falcon = bench.driver();
        Person person(bench.device);
        EmulatedBus::the().setForbidden(kSocket, true);
        COMPARE_CONTAINS(refusal(falcon->prepare(person)), "70-tactum.rules");
        FalconBench::unplug();
        COMPARE_CONTAINS(refusal(falcon->prepare(person)), "plug in its USB cable");
        EmulatedFalcon::plug(5, bench.device); // another socket
        VERIFY_RESULT(falcon->prepare(person));
    }

    /// Of two that lie elsewhere neither is taken for it: the other one's force would be a surprise.
    void ofTwoInOtherSocketsNeitherIsTaken() {
        FalconBench bench;
        FalconBench::unplug();
        const auto other = std::make_shared<EmulatedFalcon>(20);
        for (const auto& [socket, device] : {std::pair{4, bench.device}, {5, other}}) {
            device->startFirmware(true);
            EmulatedFalcon::plug(socket, device);
        }
        const auto falcon = bench.driver();
        const auto opened = falcon->open();
        COMPARE_CONTAINS(refusal(opened), "there is none at USB 1-2");
        QCOMPARE(bench.device->commands() + other->commands(), 0);
        EmulatedBus::the().unplug(4);
        QVERIFY(falcon->open());
        QVERIFY(exchange(*falcon, 50).valid > 40);
        QCOMPARE(bench.device->commands(), 0);
    }

    void withoutFirmwareItSaysWhereToGetIt() {
        FalconBench bench;
        Falcon falcon(bench.place(), FalconBench::profile(), {"/nowhere/firmware.bin"});
        Person person(bench.device);
        COMPARE_CONTAINS(refusal(falcon.prepare(person)), "/nowhere/firmware.bin");
        bench.device->startFirmware(true);
        VERIFY_RESULT(falcon.prepare(person)); // then it needs none
    }

    void troubleWithLoading_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<QString>("words");
        QTest::addRow("many deaf tries") << 0 << "";
        QTest::addRow("junk before the answer") << 1 << "";
        QTest::addRow("wrong echoes") << 2 << "";
        QTest::addRow("lost echoes") << 3 << "";
        QTest::addRow("wrong echoes without end") << 4 << "bytes are lost";
        QTest::addRow("a program that does not start") << 5 << "says nothing";
        QTest::addRow("a refused request") << 6 << "refused";
        QTest::addRow("broken transfers") << 7 << "";
    }
    void troubleWithLoading() {
        QFETCH(int, fault);
        QFETCH(QString, words);
        FalconBench bench;
        const FalconFaults faults[] = {{.deafTries = 40}, {.junkFirst = 90},     {.corruptEchoes = 2},
                                       {.lostEchoes = 1}, {.corruptEchoes = 99}, {.startsNoFirmware = true}};
        if (fault < 6) bench.device->setFaults(faults[fault]);
        if (fault == 6) EmulatedBus::the().setFaults(kSocket, {.stallControl = true});
        Person person(bench.device);
        const auto falcon = bench.driver();
        const auto ready = falcon->prepare(person);
        QVERIFY2(words.isEmpty() == ready.has_value(), ready ? "it worked" : ready.error().text.c_str());
        if (!words.isEmpty()) COMPARE_CONTAINS(refusal(ready), words.toStdString());
        QCOMPARE(bench.device->torqueCommands(), 0);
    }

    // ---- Felt.

    void readsWhereTheGripIs() {
        FalconBench bench;
        const auto falcon = bench.opened();
        QVERIFY(falcon);
        for (const Vec3& p :
             {Vec3(0, 0, 0), Vec3(0.01, 0, 0), Vec3(0, 0.03, -0.01), Vec3(-0.02, -0.01, 0.02)}) {
            bench.device->putGrip(p);
            exchange(*falcon, 60); // it jumped there
            const Run run = exchange(*falcon, 50);
            QCOMPARE_GT(run.valid, 40);
            COMPARE_NEAR(run.last.position, p, 1e-4, "m");
        }
        for (const std::uint8_t buttons : {0, 1, 2, 4, 8, 15}) {
            bench.device->setButtons(buttons);
            QCOMPARE(exchange(*falcon, 20).last.buttons, std::uint32_t(buttons));
        }
    }

    void pushesAsItIsTold() {
        FalconBench bench;
        const auto falcon = bench.opened();
        bench.device->setHand({.stiffness = 2000, .damping = 40});
        for (const Vec3& force : {Vec3(1, 0, 0), Vec3(0, -2, 0), Vec3(0, 0, 4), Vec3(-1, 2, -3)}) {
            exchange(*falcon, 100, force);
            COMPARE_NEAR(bench.device->force(), force, 0.01 * force.norm() + 0.005, "N");
        }
        QVERIFY(!bench.device->overdriven());
    }

    void neverMoreThanItsLimits() {
        FalconBench bench;
        const auto falcon = bench.opened();
        bench.device->setHand({.stiffness = 5000, .damping = 60});
        for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
            exchange(*falcon, 100, 1000 * direction);
            COMPARE_NEAR(bench.device->force(), 8 * direction, 0.08, "N");
        }
        exchange(*falcon, 100, {1e30, 0, 0}); // the motors end before the 8 N
        const Vec3 sideways = bench.device->force();
        QCOMPARE_GT(sideways.x(), 5);
        QCOMPARE_LT(sideways.x(), 8);
        QCOMPARE_LT(std::hypot(sideways.y(), sideways.z()), 0.05);
        for (const double bad : {std::nan(""), 1.0 / 0.0}) {
            exchange(*falcon, 20, {bad, 0, 0});
            QCOMPARE(bench.device->motors(), kNoTorque);
        }
        QVERIFY(!bench.device->overdriven());
        QCOMPARE(bench.device->malformed(), 0);
    }

    void zeroIsFirstAndLast() {
        FalconBench bench;
        auto falcon = bench.opened();
        QVERIFY(!bench.device->firstHadTorque());
        exchange(*falcon, 50, kPush);
        QCOMPARE_NE(bench.device->motors(), kNoTorque);
        falcon->close();
        QCOMPARE(bench.device->motors(), kNoTorque);
        VERIFY_RESULT(falcon->open());
        exchange(*falcon, 50, kPush);
        QCOMPARE_NE(bench.device->motors(), kNoTorque);
        falcon.reset();
        QCOMPARE(bench.device->motors(), kNoTorque);
    }

    /// Between opening and the first tick the hand goes wherever it likes: that is no jump.
    void theHandMayGoAnywhereBeforeTheServoBegins() {
        FalconBench bench;
        const auto falcon = bench.opened();
        bench.device->putGrip({0.02, 0, 0.01});
        QTest::qSleep(5);
        Run run;
        for (int i = 0; i < 50; ++i) {
            const DeviceSample sample = falcon->exchange({}, 1e-3);
            run.valid += sample.valid;
            if (sample.valid) run.last = sample;
            QCOMPARE(falcon->trouble(), std::string());
            QTest::qSleep(1);
        }
        QCOMPARE_GE(run.valid, 40);
        QVERIFY((run.last.position - Vec3(0.02, 0, 0.01)).norm() < 1e-4);
    }

    /// A device that hears and does not say so gets the last zero twice, the second time past everything
    /// else.
    void theLastZeroGoesTwiceToWhoDoesNotAnswer() {
        for (const bool answers : {true, false}) {
            FalconBench bench;
            const auto falcon = bench.opened();
            exchange(*falcon, 50, kPush);
            QVERIFY(bench.device->motors() != kNoTorque);
            bench.device->setFaults({.silent = !answers});
            for (int i = 0; i < 20; ++i) { // what is still to be said
                falcon->exchange({kPush}, 0);
                QTest::qSleep(1);
            }
            const int before = bench.device->commands();
            falcon->close();
            QTest::qSleep(1);
            falcon->emergencyStop(); // the bus is looked at: so it has heard all that went before
            QCOMPARE(bench.device->motors(), kNoTorque);
            if (answers)
                QCOMPARE_LE(bench.device->commands() - before, 2); // one of them may have been on its way
            else
                QCOMPARE(bench.device->commands() - before, 2);
        }
    }

    void anEmergencyStopNeedsNothingButTheLink() {
        FalconBench bench;
        const auto falcon = bench.driver();
        falcon->emergencyStop(); // of nothing
        bench.device->startFirmware(true);
        VERIFY_RESULT(falcon->open());
        exchange(*falcon, 50, kPush);
        QCOMPARE_NE(bench.device->motors(), kNoTorque);
        falcon->emergencyStop();
        QTest::qSleep(5);
        exchange(*falcon, 1);
        QCOMPARE(bench.device->motors(), kNoTorque);
        exchange(*falcon, 50, kPush);
        QCOMPARE_NE(bench.device->motors(), kNoTorque);
        const pid_t child = fork();
        if (child == 0) {
            falcon->emergencyStop();
            falcon->emergencyStop(); // the second carries the first down the line
            _exit(0);
        }
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        QCOMPARE(bench.device->motors(), kNoTorque);
    }

    // ---- With things going wrong.

    void aPushWaitsForAnswersAndTheZeroDoesNot_data() {
        QTest::addColumn<int>("onWay");
        QTest::newRow("as libnifalcon") << 1;
        QTest::newRow("one in each tick") << 2;
    }

    /// So many commands without an answer, and the next push waits: more would stand in line and come late.
    /// The zero after a push does not wait; it goes once, and the zeros after it wait again. No time passes
    /// for the driver, so that no answer seems late to it.
    void aPushWaitsForAnswersAndTheZeroDoesNot() {
        QFETCH(int, onWay);
        FalconBench bench;
        bench.settings.commandsOnWay = onWay;
        const auto falcon = bench.opened();
        exchange(*falcon, 50, kPush);
        const auto atOnce = [&](const Vec3& force) {
            for (int i = 0; i < 50; ++i) {
                falcon->exchange({force}, 0);
                QTest::qSleep(1);
            }
            return bench.device->commands();
        };
        const int before = atOnce(kPush);
        QVERIFY(bench.device->motors() != kNoTorque);
        bench.device->setFaults({.silent = true});
        const int pushes = atOnce(kPush);
        QCOMPARE(pushes - before, onWay);
        QCOMPARE(atOnce(kPush) - pushes, 0);
        QVERIFY(bench.device->motors() != kNoTorque);
        QCOMPARE(atOnce(Vec3::Zero()) - pushes, 1);
        QCOMPARE(bench.device->motors(), kNoTorque);
        QCOMPARE(atOnce(kPush) - pushes, 1);
        QCOMPARE(bench.device->motors(), kNoTorque);
    }

    /// What nobody asked for answers nothing that comes later; what broke on its way was an answer too.
    void unaskedAnswersAreNoneAndBrokenOnesAreSome() {
        FalconBench bench;
        // Of one alone nothing but time tells that it broke: its end is missed when the next one comes.
        bench.settings.commandsOnWay = 2;
        const auto falcon = bench.opened();
        exchange(*falcon, 50, kPush);
        const auto atOnce = [&] {
            const int before = bench.device->commands();
            for (int i = 0; i < 50; ++i) {
                falcon->exchange({kPush}, 0);
                QTest::qSleep(1);
            }
            return bench.device->commands() - before;
        };
        for (const FalconFaults& fault : {FalconFaults{.wrongEnds = 2}, FalconFaults{.shortReports = 2}}) {
            bench.device->setFaults(fault);
            QCOMPARE_GE(atOnce(), 40);
        }
        bench.device->setFaults({.repeats = 2});
        QCOMPARE_GE(atOnce(), 40);
        bench.device->setFaults({.silent = true});
        QCOMPARE_LE(atOnce(), 3); // two, and one that was on its way
    }

    /// Within ten exchanges nothing is valid any more and the motors are off, as the device sees it, or as
    /// soon as it hears again.
    void afterAFaultThereIsNoForce_data() {
        QTest::addColumn<int>("number");
        for (std::size_t i = 0; i < faults().size(); ++i)
            QTest::addRow("%s", faults()[i].name) << int(i);
    }
    void afterAFaultThereIsNoForce() {
        QFETCH(int, number);
        const Fault& fault = faults()[std::size_t(number)];
        FalconBench bench;
        const auto falcon = bench.opened();
        QCOMPARE_GT(exchange(*falcon, 100, kPush).valid, 80);
        QCOMPARE_NE(bench.device->motors(), kNoTorque);
        const int before = bench.device->torqueCommands();
        fault.begin(bench);
        exchange(*falcon, 12, kPush);
        if (fault.heard) QCOMPARE(bench.device->motors(), kNoTorque);
        QCOMPARE_LE(bench.device->torqueCommands(), before + 10);
        const int then = bench.device->torqueCommands();
        QCOMPARE(exchange(*falcon, 3, kPush).valid, 0);
        if (std::string_view(fault.words) != "jumped") {
            QCOMPARE(exchange(*falcon, 150, kPush).valid, 0);
            QCOMPARE(bench.device->torqueCommands(), then);
        }
        COMPARE_CONTAINS(falcon->trouble(), fault.words);
        QVERIFY(!falcon->trouble().empty());

        fault.end(bench);
        exchange(*falcon, 200);
        QCOMPARE(bench.device->motors(), kNoTorque);
        const int valid = exchange(*falcon, 50).valid;
        QCOMPARE_GT(valid, 40);
        QCOMPARE_GT(exchange(*falcon, 50, kPush).valid, 40);
        QCOMPARE_NE(bench.device->motors(), kNoTorque);
        QVERIFY(!bench.device->overdriven());
        QCOMPARE(bench.device->malformed(), 0);
    }

    void whatDoesNoHarmIsNotFelt_data() {
        QTest::addColumn<int>("fault");
        const char* names[] = {"junk before each report",
                               "reports in pieces",
                               "each report three times",
                               "a report is lost",
                               "a byte is lost",
                               "a wrong end",
                               "babble"};
        for (int i = 0; i < int(std::size(names)); ++i)
            QTest::addRow("%s", names[i]) << i;
    }
    void whatDoesNoHarmIsNotFelt() {
        QFETCH(int, fault);
        const FalconFaults harmless[] = {{.junk = 5},        {.split = true},     {.repeats = 2},
                                         {.lostReports = 1}, {.shortReports = 1}, {.wrongEnds = 1},
                                         {.babble = true}};
        FalconBench bench;
        const auto falcon = bench.opened();
        exchange(*falcon, 50, kPush);
        bench.device->setFaults(harmless[fault]);
        const int before = bench.device->torqueCommands();
        const Run run = exchange(*falcon, 400, kPush);
        QCOMPARE_GT(run.valid, 300);
        COMPARE_NEAR(run.last.position, bench.device->grip(), 5e-4, "m");
        QCOMPARE_GT(bench.device->torqueCommands(), before + 300);
    }

    /// A frozen encoder looks like a hand that holds still: the force stays what it was. The moment it moves
    /// again it has jumped.
    void afterAFrozenEncoderThereIsNoForce() {
        FalconBench bench;
        const auto falcon = bench.opened();
        exchange(*falcon, 50, kPush);
        bench.device->setFaults({.frozenEncoders = true});
        QCOMPARE_GT(exchange(*falcon, 50, kPush).valid, 40);
        bench.device->putGrip({0.04, 0, 0}); // farther than a hand gets while a busy machine pauses
        exchange(*falcon, 20, kPush);
        bench.device->setFaults({});
        exchange(*falcon, 10, kPush);
        QCOMPARE(bench.device->motors(), kNoTorque);
        COMPARE_CONTAINS(falcon->trouble(), "jumped");
    }

    void unpluggedWhileItPushes() {
        FalconBench bench;
        const auto falcon = bench.opened();
        for (int cycle = 0; cycle < 20; ++cycle) {
            exchange(*falcon, 20 + cycle, kPush);
            // After a tick that came late there is no force for a moment.
            QVERIFY(eventually([&] {
                exchange(*falcon, 1, kPush);
                return bench.device->motors() != kNoTorque;
            }));
            FalconBench::unplug();
            QCOMPARE(exchange(*falcon, 1, kPush).valid, 0);
            exchange(*falcon, 2, kPush);
            COMPARE_CONTAINS(falcon->trouble(), "unplugged");
            falcon->emergencyStop();
            const auto without = falcon->open();
            COMPARE_CONTAINS(refusal(without), "plug in its USB cable");
            QCOMPARE_NE(bench.device->motors(), kNoTorque); // it has power of its own, and knows no better
            bench.plug();
            VERIFY_RESULT(falcon->open());
            QVERIFY(!bench.device->firstHadTorque());
            QCOMPARE(bench.device->motors(), kNoTorque);
            QCOMPARE(falcon->trouble(), std::string());
            QCOMPARE_GT(exchange(*falcon, 30).valid, 20);
        }
    }

    void powerThatGoesAndComesNeedsHomingAgain() {
        FalconBench bench;
        const auto falcon = bench.opened();
        exchange(*falcon, 50, kPush);
        bench.device->setPower(false);
        bench.device->setPower(true);
        exchange(*falcon, 150, kPush);
        COMPARE_CONTAINS(falcon->trouble(), "power supply");
        Person person(bench.device);
        VERIFY_RESULT(falcon->prepare(person));
        COMPARE_CONTAINS(person.asked, "Pull the grip");
        QCOMPARE(bench.device->uploads(), 1);
        VERIFY_RESULT(falcon->open());
        QCOMPARE_GT(exchange(*falcon, 50).valid, 40);
    }

    void unpluggedWhileItIsMadeReady() {
        std::mt19937 random(5);
        for (int i = 0; i < 40; ++i) {
            FalconBench bench(100);
            const auto falcon = bench.driver();
            Person person(bench.device);
            const int after = int(random() % 60);
            std::jthread puller([after] {
                QTest::qSleep(after);
                FalconBench::unplug();
            });
            const auto ready = falcon->prepare(person);
            if (!ready) COMPARE_CONTAINS(refusal(ready), "Falcon");
            puller.join();
            exchange(*falcon, 3, kPush);
            QCOMPARE(bench.device->torqueCommands(), 0);
        }
    }
};

TACTUM_TEST(TestFalcon)

} // namespace test_falcon

#include "test_falcon.moc"
