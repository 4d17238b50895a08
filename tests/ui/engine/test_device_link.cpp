// Devices on their way into the engine: listed, made ready, given up, lost, brought back, lent, beside each
// other.
//
// What would show that a test here is wrong: the engine and its loops are the real ones, and what the device
// was sent and asked is counted by the device; every refusal stands beside what may be done.
#include <thread>

#include <QElapsedTimer>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "core/port/hand_target.h"
#include "core/runtime/local_engine.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/fake_devices.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/told_engine.h"
#include "ui/base/preferences.h"
#include "ui/engine/device_link.h"

namespace test_device_link {

using namespace tactum;
using namespace tactum::test;

namespace {

const QString kArm = QStringLiteral("fake:1-2"), kOther = QStringLiteral("fake:1-4");
using State = Preparation::State;

/// A running engine with the simulated hand, and a catalogue of two arms, the second not plugged in.
struct Bench {
    Bench() {
        catalogue.otherDesk = other;
        catalogue.other = true;
        other->name = "Other arm";
        other->plugged = false;
        if (!engine.start()) qFatal("the engine does not start");
        QObject::connect(&link, &DeviceLink::failed, [this](const QString& what) { failures << what; });
        QObject::connect(&link, &DeviceLink::ready, [this](const QString& name, bool back) {
            readied << (back ? name + QStringLiteral(" back") : name);
        });
        QObject::connect(&link, &DeviceLink::wentAway, [this](const QString& name, bool others) {
            away << (others ? name + QStringLiteral(" beside others") : name);
        });
        QObject::connect(&link, &DeviceLink::besideWentAway, [this](const QString& name, bool others) {
            away << QStringLiteral("beside: ") + (others ? name + QStringLiteral(" beside others") : name);
        });
    }
    bool begin() {
        link.setCatalogue(catalogue);
        return listed();
    }
    /// Looked once more, from the beginning.
    bool listed() {
        const int before = catalogue.lists;
        link.look();
        if (!waitFor([&] { return catalogue.lists > before && !link.devices().empty(); })) return false;
        QTest::qWait(20); // what the worker sent has come by then
        return true;
    }
    template <class Condition> bool until(Condition condition) {
        return waitFor([&] {
            engine.poll();
            link.frame();
            return condition();
        });
    }
    bool connectIt() {
        arm->go = 3;
        link.choose(kArm);
        return until([&] { return link.current() == kArm && !link.preparing(); });
    }
    bool addOther() {
        other->plugged = true;
        other->go = 3;
        if (!listed()) return false;
        link.add(kOther);
        return until([&] { return link.hands().count() == 2 && !link.preparing(); });
    }

    std::shared_ptr<FakeDesk> arm = std::make_shared<FakeDesk>(), other = std::make_shared<FakeDesk>();
    std::shared_ptr<HandTarget> mouse = std::make_shared<HandTarget>();
    FakeCatalogue catalogue{arm, mouse};
    LocalEngine engine{std::make_unique<SimulatedHand>(mouse)};
    DeviceLink link{engine};
    QStringList failures, readied, away;
};

QStringList stepsOf(const Preparation& preparation) {
    static const char* words[] = {"waits", "goes on", "done", "failed"};
    QStringList steps;
    for (const Preparation::Step& step : preparation.steps)
        steps << step.name + u' ' + QString::fromLatin1(words[int(step.state)]);
    return steps;
}

} // namespace

class TestDeviceLink : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void initTestCase() { useFoldersIn(folder_.path()); }
    void init() { QSettings().clear(); }

    void withoutACatalogueItDoesNothing() {
        Bench bench;
        QVERIFY(!bench.link.hasCatalogue());
        bench.link.look();
        bench.link.choose(kArm);
        bench.link.add(kArm);
        bench.link.lend();
        QVERIFY(!bench.link.preparing());
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        COMPARE_CONTAINS(bench.link.whyNotLend(), QStringLiteral("server"));
        QVERIFY(!bench.link.whyNotLetGo().isEmpty());
        QVERIFY(!bench.link.mayAdd(kArm));
    }

    void devicesAreListed() {
        Bench bench;
        const QSignalSpy changed(&bench.link, &DeviceLink::listChanged);
        QVERIFY(bench.begin());
        QCOMPARE(bench.link.devices().size(), std::size_t(2));
        QVERIFY(bench.link.find(kArm));
        QVERIFY(!bench.link.find(kOther));
        QVERIFY(!bench.link.find(QString()));
        const qsizetype told = changed.size();
        QCOMPARE_GT(told, 0);
        QVERIFY(bench.listed());
        QCOMPARE(changed.size(), told); // the same again is no news
        bench.other->plugged = true;
        QVERIFY(waitFor([&] { return bench.link.find(kOther) != nullptr; })); // within a second, by itself
        QCOMPARE_GT(changed.size(), told);
        QCOMPARE(bench.link.current(), kSimulatedDevice); // listed is not chosen
    }

    void aDeviceIsMadeReadyStepByStep() {
        Bench bench;
        QVERIFY(bench.begin());
        const QSignalSpy exchanged(&bench.link, &DeviceLink::exchanged),
            letsGo(&bench.link, &DeviceLink::letsGo);
        QVERIFY(bench.link.mayBegin(kArm));
        bench.link.choose(kArm);
        QVERIFY(bench.link.preparing());
        QCOMPARE(bench.link.wanted(), kArm);
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        const Preparation& preparation = bench.link.preparation();
        QVERIFY(bench.until([&] { return stepsOf(preparation).size() == 3 && preparation.progress == 0.5; }));
        QCOMPARE(stepsOf(preparation),
                 (QStringList{"Load the firmware goes on", "Find home waits", "Rest waits"}));
        QCOMPARE(preparation.name, QStringLiteral("Example arm"));
        QCOMPARE(preparation.request, QString());
        QVERIFY(bench.engine.running()); // the simulated hand goes on meanwhile
        bench.arm->go = 1;
        QVERIFY(bench.until([&] { return !preparation.request.isEmpty(); }));
        QCOMPARE(preparation.request, QStringLiteral("Push the grip in and out."));
        QCOMPARE(stepsOf(preparation),
                 (QStringList{"Load the firmware done", "Find home goes on", "Rest waits"}));
        QCOMPARE(exchanged.size(), 0);
        bench.arm->go = 3;
        QVERIFY(bench.until([&] { return !bench.link.preparing(); }));
        QCOMPARE(preparation.state, State::Done);
        QCOMPARE(stepsOf(preparation),
                 (QStringList{"Load the firmware done", "Find home done", "Rest done"}));
        QCOMPARE(preparation.request, QString());
        QCOMPARE(bench.link.current(), kArm);
        QVERIFY(bench.link.connected());
        QVERIFY(bench.link.uses(kArm));
        QVERIFY(!bench.link.simulatedHand());
        QCOMPARE(bench.readied, QStringList("Example arm"));
        QCOMPARE(exchanged.size(), 1);
        QCOMPARE(letsGo.size(), 1);
        QCOMPARE(bench.engine.device().name, "Example arm");
        QVERIFY(bench.engine.running());
        QVERIFY(!bench.engine.armed());
        QVERIFY(!bench.link.mayBegin(kArm)); // in use already
        QVERIFY(bench.link.whyNotLetGo().isEmpty());
        QCOMPARE(QSettings().value("device/chosen").toString(), kArm);
        QCOMPARE(QSettings().value("device/chosen-name").toString(), QStringLiteral("Example arm"));
        // And goes again for the simulated one.
        bench.link.choose(kSimulatedDevice);
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QVERIFY(!bench.link.connected());
        QVERIFY(!bench.link.whyNotLetGo().isEmpty());
        QVERIFY(waitFor([&] { return bench.arm->made == 0; }));
        QCOMPARE(QSettings().value("device/chosen").toString(), kSimulatedDevice);
    }

    // Its progress may be told before the window knows of the step.
    void noStepIsShownWithTheProgressOfTheNext() {
        Bench bench;
        QVERIFY(bench.begin());
        const Preparation& preparation = bench.link.preparation();
        QStringList shown;
        QObject::connect(&bench.link, &DeviceLink::preparationChanged, [&] {
            shown << QStringLiteral("%1: %2")
                         .arg(stepsOf(preparation).join(QStringLiteral(", ")))
                         .arg(preparation.progress);
        });
        bench.link.choose(kArm);
        QElapsedTimer clock;
        clock.start();
        while (bench.arm->halves < 1 && !clock.hasExpired(20'000))
            std::this_thread::yield();
        QCOMPARE(bench.arm->halves.load(), 1);
        bench.link.frame(); // before what the worker sent has come
        QVERIFY(bench.until([&] { return preparation.progress == 0.5; }));
        QCOMPARE(shown.filter(QStringLiteral("0.5")),
                 QStringList{"Load the firmware goes on, Find home waits, Rest waits: 0.5"});
    }

    void whatFailsIsNamedAndTriedAgain() {
        Bench bench;
        QVERIFY(bench.begin());
        bench.link.tryAgain(); // of nothing
        QVERIFY(!bench.link.preparing());
        bench.arm->go = 1;
        bench.arm->failAt = 1;
        bench.link.choose(kArm);
        QVERIFY(bench.until([&] { return !bench.link.preparing(); }));
        QCOMPARE(bench.link.preparation().state, State::Failed);
        QCOMPARE(stepsOf(bench.link.preparation()),
                 (QStringList{"Load the firmware done", "Find home failed", "Rest waits"}));
        QCOMPARE(bench.link.preparation().failure,
                 QStringLiteral("The grip did not move: pull it all the way out."));
        QCOMPARE(bench.failures,
                 QStringList("Example arm, step \"Find home\": The grip did not move: pull it all the "
                             "way out."));
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QVERIFY(bench.engine.running());
        QCOMPARE(bench.arm->made, 0);
        QVERIFY(bench.listed());
        QTest::qWait(50);
        QVERIFY(!bench.link.preparing()); // what failed is not tried without end
        bench.arm->failAt = -1;
        bench.arm->go = 3;
        bench.link.tryAgain();
        QVERIFY(bench.until([&] { return bench.link.current() == kArm; }));
        QCOMPARE(bench.readied, QStringList("Example arm"));
    }

    void aDeviceThatDoesNotOpenLeavesTheSimulatedHand() {
        Bench bench;
        QVERIFY(bench.begin());
        bench.arm->go = 3;
        bench.arm->failOpen = true;
        bench.link.choose(kArm);
        QVERIFY(bench.until([&] { return !bench.link.preparing(); }));
        QCOMPARE(bench.link.preparation().state, State::Failed);
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QCOMPARE(bench.failures.size(), 1);
        COMPARE_CONTAINS(bench.failures[0], QStringLiteral("The arm did not wake"));
        QVERIFY(bench.until(
            [&] { return bench.engine.running() || bench.link.hands().device(0).name != "Example arm"; }));
        QCOMPARE(bench.readied, QStringList());
    }

    void aPreparationIsGivenUp() {
        Bench bench;
        QVERIFY(bench.begin());
        bench.link.giveUp(); // of nothing
        bench.link.choose(kArm);
        QVERIFY(bench.until([&] { return bench.arm->preparing.load(); }));
        bench.link.giveUp();
        QVERIFY(bench.link.preparation().givingUp);
        QVERIFY(bench.until([&] { return !bench.link.preparing(); }));
        QCOMPARE(bench.link.preparation().state, State::GivenUp);
        QVERIFY(!bench.link.preparation().givingUp);
        QCOMPARE(bench.failures, QStringList());
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QCOMPARE(bench.arm->made, 0);
    }

    void oneThatGoesOnAllTheSameIsNotTaken() {
        Bench bench;
        QVERIFY(bench.begin());
        bench.arm->stubborn = true;
        bench.link.choose(kArm);
        QVERIFY(bench.until([&] { return bench.arm->preparing.load(); }));
        bench.link.giveUp();
        QTest::qWait(30);
        QVERIFY(bench.link.preparing());
        QVERIFY(!bench.link.mayBegin(kOther));
        bench.arm->go = 3;
        QVERIFY(bench.until([&] { return !bench.link.preparing(); }));
        QCOMPARE(bench.link.preparation().state, State::GivenUp);
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QCOMPARE(bench.readied, QStringList());
    }

    void whoThinksBetterOfItGetsTheOther() {
        Bench bench;
        bench.other->plugged = true;
        bench.other->go = 3;
        QVERIFY(bench.begin());
        bench.link.choose(kArm);
        QVERIFY(bench.until([&] { return bench.arm->preparing.load(); }));
        bench.link.choose(kOther);
        QVERIFY(bench.until([&] { return bench.link.current() == kOther; }));
        QCOMPARE(bench.arm->made, 0);
        QCOMPARE(bench.readied, QStringList("Other arm"));
        QCOMPARE(bench.failures, QStringList());
    }

    void whatIsLostComesBack() {
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(bench.connectIt());
        bench.engine.setArmed(true);
        bench.arm->plugged = false;
        QVERIFY(bench.until([&] {
            bench.link.look();
            return bench.link.lost();
        }));
        QCOMPARE(bench.away, QStringList("Example arm"));
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QCOMPARE(bench.link.wanted(), kArm);
        QVERIFY(!bench.engine.armed());
        bench.arm->plugged = true;
        QVERIFY(bench.until([&] {
            bench.link.look();
            return bench.link.current() == kArm;
        }));
        QCOMPARE(bench.readied, (QStringList{"Example arm", "Example arm back"}));
        QVERIFY(!bench.link.lost());
        QVERIFY(!bench.engine.armed());
    }

    // A maker's library hides a device that is open.
    void whatIsHiddenButReadsIsThere() {
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(bench.connectIt());
        bench.catalogue.hidden = true;
        for (int i = 0; i < 5; ++i)
            QVERIFY(bench.listed());
        QVERIFY(!bench.link.find(kArm));
        QCOMPARE(bench.link.current(), kArm);
        QCOMPARE(bench.away, QStringList());
    }

    void theChosenOneIsBroughtBackAtTheNextStart() {
        {
            Bench bench;
            QVERIFY(bench.begin());
            QVERIFY(bench.connectIt());
            QVERIFY(bench.addOther());
        }
        Bench bench;
        bench.arm->go = 3;
        bench.other->go = 3;
        bench.other->plugged = true;
        QVERIFY(bench.begin());
        QVERIFY(bench.until([&] { return bench.link.hands().count() == 2 && !bench.link.preparing(); }));
        QCOMPARE(bench.link.idOf(0), kArm);
        QCOMPARE(bench.link.idOf(1), kOther);
        QCOMPARE(bench.readied, (QStringList{"Example arm back", "Other arm back"}));
    }

    void whatIsNotThereAnyMoreIsSaidOnce() {
        {
            Bench bench;
            QVERIFY(bench.begin());
            QVERIFY(bench.connectIt());
            QVERIFY(bench.addOther());
        }
        Bench bench;
        bench.arm->plugged = false;
        QSignalSpy missing(&bench.link, &DeviceLink::missing);
        QVERIFY(bench.begin());
        QVERIFY(waitFor([&] { return !missing.empty(); }));
        QCOMPARE(missing[0][0].toStringList(), (QStringList{"Example arm", "Other arm"}));
        QVERIFY(bench.listed());
        QCOMPARE(missing.size(), 1);
    }

    void handsStandBesideEachOther() {
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(!bench.link.mayAdd(kSimulatedDevice)); // the mouse leads one hand alone
        QVERIFY(!bench.link.mayAdd(QString()));
        QVERIFY(bench.connectIt());
        QVERIFY(!bench.link.mayAdd(kArm));
        QVERIFY(bench.listed()); // a spare simulated one
        QVERIFY(waitFor([&] { return bench.link.mayAdd(kSimulatedDevice); }));
        QVERIFY(bench.addOther());
        QCOMPARE(bench.link.idOf(1), kOther);
        QVERIFY(bench.link.leadsItself(1));
        QVERIFY(bench.link.preparation().beside);
        QVERIFY(!bench.link.mayBegin(kOther)); // another hand has it
        bench.link.choose(kOther);
        QCOMPARE(bench.link.current(), kArm);
        QCOMPARE(bench.link.idOf(1), kOther);
        QVERIFY(bench.engine.running());
        bench.link.add(kSimulatedDevice);
        QCOMPARE(bench.link.hands().count(), std::size_t(3));
        QCOMPARE(bench.link.simulatedHand(), std::optional<std::size_t>(2));
        bench.link.remove(1);
        QCOMPARE(bench.link.hands().count(), std::size_t(2));
        QCOMPARE(bench.link.idOf(1), kSimulatedDevice);
        QVERIFY(waitFor([&] { return bench.other->made == 0; }));
        QVERIFY(bench.listed());
        QTest::qWait(50);
        QVERIFY(!bench.link.uses(kOther)); // what was removed stays away
        // The first becomes the simulated one: the mouse leads one hand.
        bench.link.choose(kSimulatedDevice);
        QCOMPARE(bench.link.hands().count(), std::size_t(1));
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QCOMPARE(bench.failures, QStringList());
    }

    void aHandThatIsLostWaitsForTheForceOfOthers() {
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(bench.connectIt());
        QVERIFY(bench.addOther());
        bench.link.hands().setAllArmed(true);
        bench.other->plugged = false;
        QVERIFY(bench.until([&] {
            bench.link.look();
            return bench.link.gone(1);
        }));
        QCOMPARE(bench.away, QStringList("beside: Other arm beside others"));
        QCOMPARE(bench.link.hands().count(), std::size_t(2));
        QVERIFY(bench.link.hands().armed(0));
        QVERIFY(!bench.link.hands().armed(1));
        bench.link.hands().setAllArmed(false);
        QVERIFY(bench.until([&] { return bench.link.hands().count() == 1; }));
        QCOMPARE(bench.link.current(), kArm);
        // It comes back by itself, once.
        bench.other->plugged = true;
        QVERIFY(bench.until([&] {
            bench.link.look();
            return bench.link.hands().count() == 2;
        }));
        QCOMPARE(bench.readied.back(), QStringLiteral("Other arm back"));
    }

    // What comes back waits while a person has force.
    void whatComesBackWaitsForTheForce() {
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(bench.connectIt());
        QVERIFY(bench.addOther());
        bench.other->plugged = false;
        QVERIFY(bench.until(
            [&] { return bench.link.hands().count() == 1; })); // it looks by itself, not too often to see it
        bench.engine.setArmed(true);
        bench.other->plugged = true;
        QVERIFY(bench.until([&] {
            bench.link.look();
            return bench.link.preparation().request.contains(QStringLiteral("when the forces are off"));
        }));
        QCOMPARE(bench.link.hands().count(), std::size_t(1));
        QVERIFY(bench.engine.armed());
        bench.engine.setArmed(false);
        QVERIFY(bench.until([&] { return bench.link.hands().count() == 2; }));
    }

    void aDeviceIsLentAndTakenBack() {
        Bench bench;
        QVERIFY(bench.begin());
        QVERIFY(!bench.link.whyNotLend().isEmpty()); // a simulated hand
        QVERIFY(bench.connectIt());
        QCOMPARE(bench.link.whyNotLend(), QString());
        bench.link.stop().buttons = 2;
        std::shared_ptr<std::unique_ptr<HapticDevice>> device;
        QString failure;
        QObject::connect(&bench.link, &DeviceLink::lent, [&](const auto& given, const QString& why) {
            device = given;
            failure = why;
        });
        bench.link.lend();
        QVERIFY(bench.until([&] { return device || !failure.isEmpty(); }));
        QCOMPARE(failure, QString());
        QCOMPARE(bench.link.current(), kSimulatedDevice);
        QCOMPARE((*device)->info().name, "Example arm");
        // With the button that ends all force.
        bench.arm->buttons = 2;
        QVERIFY((*device)->exchange({}, 1e-3).stopped);
        bench.arm->buttons = 0;
        QVERIFY(bench.listed());
        QTest::qWait(50);
        QVERIFY(!bench.link.preparing()); // nobody takes it back meanwhile
        device.reset();
        bench.link.takeBack();
        QVERIFY(bench.until([&] { return bench.link.current() == kArm; }));
        QVERIFY(bench.addOther());
        QVERIFY(!bench.link.whyNotLend().isEmpty()); // several hands
    }

    void aFileThatItLacksIsGiven() {
        Bench bench;
        bench.catalogue.lacking = true;
        QVERIFY(bench.begin());
        QCOMPARE(bench.link.find(kArm)->lacks, "firmware (*.bin)");
        QSignalSpy supplied(&bench.link, &DeviceLink::supplied);
        bench.link.supply(kArm, QStringLiteral("/tmp/notes.txt"));
        QVERIFY(bench.until([&] { return !bench.failures.isEmpty(); }));
        QCOMPARE(bench.failures, QStringList("The file is no firmware."));
        QVERIFY(bench.catalogue.lacking);
        bench.link.supply(kArm, QStringLiteral("/tmp/arm.bin"));
        QVERIFY(bench.until([&] { return !supplied.empty(); }));
        QCOMPARE(supplied[0][0].toString(), QStringLiteral("The firmware /tmp/arm.bin is kept."));
        QVERIFY(waitFor([&] { return bench.link.find(kArm)->lacks.empty(); })); // it looks again
    }

    void whatFailedForWantOfAFileIsTriedAgain() {
        Bench bench;
        QVERIFY(bench.begin());
        bench.arm->failAt = 0;
        bench.link.choose(kArm);
        QVERIFY(bench.until([&] { return bench.link.preparation().state == State::Failed; }));
        bench.arm->failAt = -1;
        bench.arm->go = 3;
        bench.link.supply(kOther, QStringLiteral("/tmp/arm.bin")); // of another one
        QTest::qWait(50);
        QVERIFY(!bench.link.preparing());
        bench.link.supply(kArm, QStringLiteral("/tmp/arm.bin"));
        QVERIFY(bench.until([&] { return bench.link.current() == kArm; }));
    }

    void measuredFiguresAreKept() {
        Bench bench;
        QVERIFY(bench.begin());
        QSignalSpy kept(&bench.link, &DeviceLink::figuresKept);
        bench.link.keepFigures(QStringLiteral("Example arm"), "damping = 4");
        QVERIFY(waitFor([&] { return !kept.empty(); }));
        QCOMPARE(kept[0][0].toString(), QStringLiteral("The figures of Example arm are kept."));
        QVERIFY(kept[0][1].toBool());
        QCOMPARE(bench.catalogue.keptFigures, "damping = 4");
    }

    void noDeviceGivesMoreThanThePersonPrefers() {
        Bench bench;
        Preferences::instance().set(Preferred::LargestForce, 1.5);
        QCOMPARE_EQ(withOwnLimit(std::make_unique<FakeDevice>(bench.arm))->info().maxForce, 1.5);
        Preferences::instance().set(Preferred::LargestForce, 0);
        QCOMPARE_EQ(withOwnLimit(std::make_unique<FakeDevice>(bench.arm))->info().maxForce, 6);
    }

    // At a server hands come and go with it.
    void handsOfAServerAreFollowed() {
        ToldEngine engine(1);
        engine.of[0].device.real = true;
        DeviceLink link(engine);
        QVERIFY(link.connected());
        const QSignalSpy followed(&link, &DeviceLink::handsFollowed);
        link.follow();
        QCOMPARE(followed.size(), 0);
        engine.of.resize(2);
        link.follow();
        QCOMPARE(followed.size(), 1);
        QCOMPARE(link.simulatedHand(), std::optional<std::size_t>(1));
        engine.of[1].device.real = true;
        link.follow();
        QCOMPARE(followed.size(), 2);
        QVERIFY(link.leadsItself(1));
        link.follow();
        QCOMPARE(followed.size(), 2);
    }
};

TACTUM_TEST(TestDeviceLink)

} // namespace test_device_link

#include "test_device_link.moc"
