// Two hands at a server: what a client sees of each, and which of them it moves.
//
// What would show that a test here is wrong: forces are those of the spring, K times the depth of each hand.
#include <QTest>

#include "tests/core/protocol/guest.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_server_hands {

using namespace tactum;
using test::eventually;
using test::Guest;
using test::Served;

namespace {

constexpr std::array<double, 2> kDepths{1e-3, 2e-3};
constexpr double kExact = 0.02; ///< of a force

double forceOf(std::size_t hand) {
    return kStiffness.initial * kDepths[hand];
}

v1::OrderRequest arm(bool on, std::uint32_t hand) {
    v1::OrderRequest request;
    request.set_arm(on);
    request.set_of(hand);
    return request;
}

bool feels(const Served& served, std::size_t hand, double force) {
    return std::abs(served.push(hand) - force) < kExact * forceOf(hand);
}

/// Both fingers go in, each to its own depth, when the force is all there.
bool pressBoth(Served& served, Guest& guest) {
    if (!guest.order(arm(true, 0)).ok() || !guest.order(arm(true, 1)).ok()) return false;
    if (!eventually([&] {
            const v1::State state = guest.newest();
            return state.gain() == 1 && state.other_size() == 1 && state.other(0).gain() == 1;
        }))
        return false;
    for (std::size_t hand = 0; hand < 2; ++hand)
        served.setHeight(kProxyRadius.initial - kDepths[hand], hand);
    return eventually([&] { return feels(served, 0, forceOf(0)) && feels(served, 1, forceOf(1)); });
}

} // namespace

class TestServerHands : public QObject {
    Q_OBJECT

private slots:
    void init() {
        QCOMPARE(served_.emplace(ServerSettings{}, 2).begin(), std::string());
        guest_.emplace(served_->target());
        QVERIFY(guest_->attend("guest", true, 250).ok());
        QVERIFY(eventually([&] { return guest_->newest().other_size() == 1; }));
    }
    void cleanup() {
        guest_.reset();
        served_.reset();
    }
    void aGuestSeesWhatEachHandFeels();
    void stopIsForAll();
    void whoNamesNoHandMeansTheFirstByForcesOnAndAllByForcesOff();
    void theForceOfAllFadesWithWhoHadThePen();
    void anOrderIsForTheHandThatItNames();
    void aPushIsOnTheHandThatItNames();
    void whatOneDeviceLacksIsToldOfIt();

private:
    std::optional<Served> served_;
    std::optional<Guest> guest_;
};

void TestServerHands::aGuestSeesWhatEachHandFeels() {
    QCOMPARE(guest_->welcome().device().name(), std::string("Probe"));
    QCOMPARE(guest_->welcome().other_size(), 1);
    QCOMPARE(guest_->welcome().other(0).name(), std::string("Probe 2"));
    QVERIFY(pressBoth(*served_, *guest_));
    v1::State state;
    QVERIFY(eventually([&] {
        state = guest_->newest();
        return std::abs(state.force().z() - forceOf(0)) < kExact * forceOf(0) &&
               std::abs(state.other(0).force().z() - forceOf(1)) < kExact * forceOf(1) &&
               std::abs(state.finger().z() - (kProxyRadius.initial - kDepths[0])) < 1e-9 &&
               std::abs(state.other(0).finger().z() - (kProxyRadius.initial - kDepths[1])) < 1e-9; // arrived
    }));
    const v1::Hand& second = state.other(0);
    COMPARE_NEAR(second.proxy().z(), kProxyRadius.initial, 1e-9, "m");
    QCOMPARE_EQ(second.contacts(), 1u);
    QCOMPARE_EQ(second.contact(0).object(), 1u);
    COMPARE_NEAR(second.contact(0).normal().z(), 1.0, 1e-9, "");
    QVERIFY(state.armed() && second.armed());
    for (const std::uint32_t hand : {0u, 1u})
        QVERIFY(eventually([&] { return guest_->heardOf(hand, v1::Event::TOUCH); }));
    served_->setHeight(0.01, 1);
    QVERIFY(eventually([&] { return guest_->heardOf(1, v1::Event::LEAVE); }));
    QVERIFY(!guest_->heardOf(0, v1::Event::LEAVE));
}

void TestServerHands::stopIsForAll() {
    QVERIFY(pressBoth(*served_, *guest_));
    v1::OrderRequest stop;
    stop.mutable_stop();
    QVERIFY(guest_->order(stop).ok());
    QVERIFY(eventually([&] { return served_->push(0) == 0 && served_->push(1) == 0; }));
    QVERIFY(!served_->stage->armed());
}

// A client that knows of one hand gives none to those that it does not see, and ends that of all.
void TestServerHands::whoNamesNoHandMeansTheFirstByForcesOnAndAllByForcesOff() {
    v1::OrderRequest on, off;
    on.set_arm(true);
    off.set_arm(false);
    QVERIFY(guest_->order(on).ok());
    QVERIFY(eventually([&] { return guest_->newest().armed(); }));
    const std::uint64_t seen = guest_->newest().number();
    QVERIFY(eventually([&] { return guest_->newest().number() > seen + 10; }));
    QVERIFY(!guest_->newest().other(0).armed());
    QVERIFY(pressBoth(*served_, *guest_));
    QVERIFY(guest_->order(off).ok());
    QVERIFY(eventually([&] { return served_->push(0) == 0 && served_->push(1) == 0; }));
    QVERIFY(eventually([&] { return !guest_->newest().armed() && !guest_->newest().other(0).armed(); }));
}

void TestServerHands::theForceOfAllFadesWithWhoHadThePen() {
    QVERIFY(pressBoth(*served_, *guest_));
    guest_->leave();
    QVERIFY(eventually([&] { return served_->push(0) == 0 && served_->push(1) == 0; }));
    QVERIFY(!served_->stage->armed());
}

void TestServerHands::anOrderIsForTheHandThatItNames() {
    v1::OrderRequest second = arm(true, 1);
    v1::OrderReply reply;
    QVERIFY(guest_->order(second, &reply).ok());
    QVERIFY(reply.armed());
    QVERIFY(eventually([&] { return guest_->newest().other(0).armed(); }));
    QVERIFY(!guest_->newest().armed());
    second.set_of(2);
    const grpc::Status refused = guest_->order(second);
    QCOMPARE(refused.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
    COMPARE_CONTAINS(refused.error_message(), "there is no hand 2");
    // Of a workspace that is said as before: it is the first hand's.
    v1::OrderRequest workspace;
    workspace.mutable_workspace()->set_scale(2);
    for (const int axis : {1, 2, 3})
        workspace.mutable_workspace()->add_axis(axis);
    QVERIFY(guest_->order(workspace).ok());
    QVERIFY(eventually([&] { return std::abs(guest_->newest().finger().z() - 0.02) < 1e-9; }));
    COMPARE_NEAR(guest_->newest().other(0).finger().z(), 0.01, 1e-9, "m");
}

void TestServerHands::aPushIsOnTheHandThatItNames() {
    QVERIFY(pressBoth(*served_, *guest_));
    constexpr double kPush = 0.5; // N
    v1::Word word;
    word.mutable_push()->mutable_force()->set_z(kPush);
    word.mutable_push()->set_hand(1);
    QVERIFY(eventually([&] {
        guest_->say(word);
        return feels(*served_, 1, forceOf(1) + kPush);
    }));
    QVERIFY(feels(*served_, 0, forceOf(0)));
    word.mutable_push()->set_hand(9);
    guest_->say(word); // on none
    QVERIFY(eventually([&] { return feels(*served_, 1, forceOf(1)); }));
}

void TestServerHands::whatOneDeviceLacksIsToldOfIt() {
    QVERIFY(pressBoth(*served_, *guest_));
    served_->setReadable(false, 1);
    QVERIFY(eventually([&] { return guest_->newest().other(0).gain() == 0; }));
    QVERIFY(!guest_->newest().other(0).why().empty());
    QVERIFY(guest_->heardOf(1, v1::Event::FORCE));
    QVERIFY(feels(*served_, 0, forceOf(0)));
    QCOMPARE(guest_->newest().gain(), 1.0);
}

TACTUM_TEST(TestServerHands)

} // namespace test_server_hands

#include "test_server_hands.moc"
