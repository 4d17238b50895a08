// The server as clients see it: one plate, a finger that the test leads, real sockets on this machine.
//
// What would show that a test here is wrong: forces are those of the spring, K times depth, and of a replay
// in this process.
#include <cmath>
#include <cstring>
#include <thread>

#include <QTest>

#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "tests/core/protocol/guest.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_server {

using namespace tactum;
using test::eventually;
using test::Guest;
using test::Served;

namespace {

constexpr double kDepth = 1e-3;

v1::Edit stiffness(double value) {
    v1::Edit edit;
    edit.mutable_material()->set_stiffness(value);
    return edit;
}

v1::OrderRequest arm(bool on) {
    v1::OrderRequest request;
    request.set_arm(on);
    return request;
}

/// A ball of 20 * 4^divisions triangles as an upload.
struct BallUpload {
    v1::UploadHead head;
    std::string bytes;

    explicit BallUpload(int divisions) {
        const auto ball = test::ball(0.02, divisions);
        v1::MeshHead* mesh = head.mutable_mesh();
        mesh->set_positions(ball->positions.size());
        mesh->set_triangles(ball->triangles.size());
        mesh->set_doubles(true);
        for (const Vec3& p : ball->positions)
            bytes.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(double));
        bytes.append(reinterpret_cast<const char*>(ball->triangles.data()), 12 * ball->triangles.size());
    }
};

/// The finger is in the plate and the force all there.
bool press(Served& served, Guest& guest) {
    if (!guest.order(arm(true)).ok()) return false;
    if (!eventually([&] { return guest.newest().gain() == 1; })) return false;
    served.setHeight(kProxyRadius.initial - kDepth);
    return eventually([&] { return std::abs(served.push() - kStiffness.initial * kDepth) < 1e-3; });
}

} // namespace

class TestServer : public QObject {
    Q_OBJECT

private slots:
    void aGuestSeesAndChangesWhatIsFelt();
    void anEditIsWholeOrNotAtAll();
    void stopNeedsNoPen();
    void aSilentGuestLosesTheForce();
    void aGuestThatIsGoneLosesTheForce();
    void thePenIsAskedForAndGiven();
    void statesAreTheNewest();
    void statesComeAtTheRateAskedFor();
    void anUploadIsFeltWhenItIsReady();
    void aCancelledUploadLeavesNothing();
    void aReplayGivesTheSameBits();
    void describesTheScene();
    void keysOfNobodyAreRefused();
    void theServerEndsAndSaysSo();
};

void TestServer::aGuestSeesAndChangesWhatIsFelt() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true, 250).ok());
    QVERIFY(guest.welcome().pen());
    QCOMPARE(guest.welcome().device().name(), std::string("Probe"));
    QVERIFY(press(served, guest));
    v1::Applied applied;
    QVERIFY(guest.apply(stiffness(400), &applied).ok());
    QVERIFY(eventually([&] { return std::abs(served.push() - 400 * kDepth) < 1e-3; }));
    QVERIFY(eventually([&] { return guest.newest().revision() == applied.revision(); }));
    QVERIFY(eventually([&] { return std::abs(guest.newest().force().z() - 400 * kDepth) < 1e-3; }));
    const v1::State state = guest.newest();
    QCOMPARE_EQ(state.contacts(), 1u);
    QCOMPARE_EQ(state.contact(0).object(), 1u);
    COMPARE_NEAR(state.contact(0).normal().z(), 1.0, 1e-9, "");
    COMPARE_NEAR(state.finger().z(), kProxyRadius.initial - kDepth, 1e-9, "m");
    COMPARE_NEAR(state.proxy().z(), kProxyRadius.initial, 1e-9, "m");
    QVERIFY(guest.heard(v1::Event::TOUCH));
    QVERIFY(guest.heard(v1::Event::SCENE));
}

void TestServer::anEditIsWholeOrNotAtAll() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    const auto before = served.stage->scenery();
    v1::Transaction both;
    *both.add_edit() = stiffness(300);
    both.add_edit()->set_remove(77);
    const grpc::Status status = guest.apply(both);
    QCOMPARE_EQ(int(status.error_code()), int(grpc::StatusCode::FAILED_PRECONDITION));
    COMPARE_BEGINS(status.error_message(), "edit 2");
    QVERIFY(*served.stage->scenery().scene == *before.scene);
    both.set_base(before.revision);
    both.mutable_edit()->RemoveLast();
    QVERIFY(guest.apply(both).ok());
    COMPARE_CONTAINS(guest.apply(both).error_message(), "look at it again"); // stale by now
}

void TestServer::stopNeedsNoPen() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest writer(served.target()), reader(served.target());
    QVERIFY(writer.attend("writer", true, 250).ok());
    QVERIFY(reader.attend("reader", false).ok());
    QVERIFY(press(served, writer));
    COMPARE_CONTAINS(reader.order(arm(false)).error_message(), "writer has the pen");
    v1::OrderRequest stop;
    stop.mutable_stop();
    v1::OrderReply reply;
    QVERIFY(reader.order(stop, &reply).ok());
    QVERIFY(!reply.armed());
    QVERIFY(eventually([&] { return served.push() == 0; }));
    QVERIFY(eventually([&] { return writer.heard(v1::Event::FORCE, "reader has stopped all force"); }));
    QVERIFY(!writer.newest().armed() || eventually([&] { return !writer.newest().armed(); }));
}

void TestServer::aSilentGuestLosesTheForce() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true, 250).ok());
    QVERIFY(press(served, guest));
    guest.setReading(false), guest.setBeating(false);
    QVERIFY(eventually([&] { return served.push() == 0; }));
    QVERIFY(eventually([&] { return guest.heard(v1::Event::FORCE, "not heard any more"); }));
    guest.setReading(true), guest.setBeating(true);
    served.setHeight(0.01);        // no force comes back under load
    QVERIFY(press(served, guest)); // it may go on, when it says so
}

void TestServer::aGuestThatIsGoneLosesTheForce() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    {
        Guest guest(served.target());
        QVERIFY(guest.attend("guest", true, 250).ok());
        QVERIFY(press(served, guest));
    }
    QVERIFY(eventually([&] { return served.push() == 0; }));
    QVERIFY(eventually([&] { return served.stage->attending() == 0; }));
    QVERIFY(!served.stage->armed());
    Guest next(served.target());
    QVERIFY(next.attend("next", true).ok());
    QVERIFY(next.welcome().pen());
}

void TestServer::thePenIsAskedForAndGiven() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest first(served.target()), second(served.target());
    QVERIFY(first.attend("first", true).ok());
    QVERIFY(second.attend("second", true).ok());
    QVERIFY(!second.welcome().pen());
    COMPARE_CONTAINS(second.apply(stiffness(300)).error_message(), "first has the pen");
    v1::OrderRequest ask, give;
    ask.mutable_ask();
    v1::OrderReply reply;
    QVERIFY(second.order(ask, &reply).ok());
    QVERIFY(!reply.pen());
    QVERIFY(eventually([&] { return first.heard(v1::Event::PEN_ASKED, "second"); }));
    QVERIFY(!second.heard(v1::Event::PEN_ASKED)); // it is told to who has it alone
    give.mutable_give()->set_to("second");
    QVERIFY(!second.order(give).ok());
    QVERIFY(first.order(give).ok());
    QVERIFY(eventually([&] { return second.heard(v1::Event::PEN, "second"); }));
    QVERIFY(second.apply(stiffness(300)).ok());
}

// Who does not read gets no pile of old states: when it reads again the first few are old, and no more.
void TestServer::statesAreTheNewest() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", false, 1000).ok());
    QVERIFY(eventually([&] { return guest.states() > 100; }));
    guest.setReading(false); // no credits, while its words go on
    std::size_t before = 0;
    QVERIFY(eventually(
        [&] { return std::exchange(before, guest.states()) == guest.states() && guest.states() > 100; }));
    const std::uint64_t ticks = served.exchanges();
    QVERIFY(eventually([&] { return served.exchanges() > ticks + 500; }));
    QCOMPARE_LT(guest.states(), before + 33); // the credits, at most half of what is kept of their times
    guest.setReading(true);
    QVERIFY(eventually([&] { return guest.states() > before + 100; }));
}

void TestServer::statesComeAtTheRateAskedFor() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest slow(served.target()), none(served.target());
    QVERIFY(slow.attend("slow", false, 20).ok());
    QVERIFY(none.attend("none", false, -1).ok());
    QVERIFY(eventually([&] { return slow.states() > 5; }));
    const auto first = slow.newest();
    QVERIFY(eventually([&] { return slow.newest().number() >= first.number() + 10; }));
    const auto last = slow.newest();
    const double each =
        1e-9 * double(last.time_ns() - first.time_ns()) / double(last.number() - first.number());
    QCOMPARE_GT(each, 0.045); // never sooner; later when the machine is busy
    QCOMPARE_EQ(none.states(), std::size_t(0));
}

void TestServer::anUploadIsFeltWhenItIsReady() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true, 250).ok());
    QVERIFY(press(served, guest));
    const BallUpload ball(4);
    v1::Uploaded uploaded;
    QVERIFY(guest.upload(ball.head, ball.bytes, &uploaded).ok());
    QCOMPARE_EQ(uploaded.triangles(), std::uint64_t(20 * 256));
    QCOMPARE_EQ(served.stage->scenery().scene->objects.size(), std::size_t(1)); // not yet
    v1::Transaction edits;
    edits.add_edit()->mutable_add()->set_upload(uploaded.upload());
    edits.mutable_edit(0)->mutable_add()->mutable_pose()->mutable_position()->set_x(0.06);
    edits.mutable_edit(0)->mutable_add()->set_name("ball");
    v1::Applied applied;
    QVERIFY(guest.apply(edits, &applied).ok());
    QCOMPARE_EQ(applied.added_size(), 1);
    QVERIFY(eventually([&] { return guest.newest().revision() == applied.revision(); }));
    const auto scene = served.stage->scenery().scene;
    QCOMPARE_EQ(scene->objects.size(), std::size_t(2));
    QVERIFY(*scene->objects[1].geometry == *test::ball(0.02, 4));        // every bit of it
    COMPARE_NEAR(served.push(), kStiffness.initial * kDepth, 1e-3, "N"); // the contact stayed
}

void TestServer::aCancelledUploadLeavesNothing() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    grpc::ClientContext context;
    auto call = guest.stub().Upload(&context);
    BallUpload ball(3);
    v1::Piece piece;
    *piece.mutable_head() = ball.head;
    piece.mutable_head()->set_key(guest.welcome().key());
    piece.mutable_head()->set_size(ball.bytes.size());
    piece.set_bytes(ball.bytes.substr(0, 1000));
    QVERIFY(call->Write(piece));
    context.TryCancel();
    QCOMPARE_EQ(int(call->Finish().error_code()), int(grpc::StatusCode::CANCELLED));
    // One that ends too soon, one that lies about its size.
    ball.head.set_size(ball.bytes.size() + 1);
    COMPARE_CONTAINS(guest.upload(ball.head, ball.bytes, nullptr).error_message(), "before it was complete");
    ball.head.set_size(ball.bytes.size() - 1);
    COMPARE_CONTAINS(guest.upload(ball.head, ball.bytes, nullptr).error_message(), "more bytes came");
    v1::Edit add;
    add.mutable_add()->set_upload(1);
    COMPARE_CONTAINS(guest.apply(add).error_message(), "no upload 1");
}

void TestServer::aReplayGivesTheSameBits() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    v1::Edit friction;
    friction.mutable_material()->set_static_friction(0.5);
    friction.mutable_material()->set_dynamic_friction(0.4);
    QVERIFY(guest.apply(friction).ok());
    std::vector<FingerPoint> path;
    std::string bytes;
    for (int i = 0; i < 20'000; ++i) { // more than one message holds
        const double t = 1e-3 * i;
        path.push_back({t, {0.03 * std::sin(0.7 * t), 0.02 * std::sin(t), 2e-3 * std::cos(3 * t)}});
        const double row[4] = {t, path.back().position.x(), path.back().position.y(),
                               path.back().position.z()};
        bytes.append(reinterpret_cast<const char*>(row), sizeof row);
    }
    grpc::ClientContext context;
    test::setDeadline(context);
    v1::ReplayRequest request;
    request.set_key(guest.welcome().key());
    request.set_path(bytes);
    auto call = guest.stub().Replay(&context, request);
    v1::ReplayRows rows;
    std::string all;
    while (call->Read(&rows))
        all += rows.rows();
    QVERIFY(call->Finish().ok());
    const auto world = compile(*served.stage->scenery().scene).value();
    const TouchTrace expected = replay(*world, path);
    QCOMPARE_EQ(all.size(), expected.size() * 7 * sizeof(double));
    int touching = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        double row[7];
        std::memcpy(row, all.data() + i * sizeof row, sizeof row);
        QCOMPARE_EQ(row[3], expected[i].force.x());
        QCOMPARE_EQ(row[4], expected[i].force.y());
        QCOMPARE_EQ(row[5], expected[i].force.z());
        QCOMPARE_EQ(row[0], expected[i].proxy.x());
        touching += expected[i].contacts > 0;
    }
    QCOMPARE_GT(touching, 1000);
}

void TestServer::describesTheScene() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    QVERIFY(guest.apply(stiffness(432)).ok());
    grpc::ClientContext context;
    v1::DescribeRequest request;
    request.set_key(guest.welcome().key());
    v1::SceneDescription scene;
    QVERIFY(guest.stub().Describe(&context, request, &scene).ok());
    QCOMPARE_EQ(scene.object_size(), 1);
    QCOMPARE(scene.object(0).name(), std::string("plate"));
    QCOMPARE_EQ(scene.object(0).triangles(), std::uint64_t(2));
    QCOMPARE_EQ(scene.object(0).surface(0).stiffness(), 432.0);
}

void TestServer::keysOfNobodyAreRefused() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target()), stranger(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    const auto refused = [](const grpc::Status& status) {
        return status.error_code() == grpc::StatusCode::UNAUTHENTICATED;
    };
    const BallUpload ball(0);
    v1::Transaction guessed;
    guessed.set_key(std::string(16, '\0'));
    *guessed.add_edit() = stiffness(300);
    QVERIFY(refused(stranger.apply(guessed)));
    QVERIFY(refused(stranger.order(arm(true))));
    QVERIFY(refused(stranger.upload(ball.head, ball.bytes, nullptr)));
    QCOMPARE_EQ(served.stage->scenery().scene->objects[0].surfaces[0].material.stiffness, kStiffness.initial);
}

void TestServer::theServerEndsAndSaysSo() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    served.server.reset();
    QVERIFY(eventually([&] { return guest.ended(); }));
}

TACTUM_TEST(TestServer)

} // namespace test_server

#include "test_server.moc"
