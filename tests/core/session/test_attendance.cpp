// Who attends, who has the pen, who was silent for too long; and secrets.
#include <set>

#include <QTest>

#include "core/session/attendance.h"
#include "core/session/secret.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_attendance {

using namespace tactum;

class TestAttendance : public QObject {
    Q_OBJECT

private slots:
    void thePenGoesToWhoWantsItFirst();
    void onlyTheHolderPassesIt();
    void whoAsksWaitsForAnAnswer();
    void silenceTakesThePen();
    void keysTellClientsApart();
    void namesAreSafeToPrint();
    void noMoreThanCanAttend();
    void secretsDifferAndCompare();
};

void TestAttendance::thePenGoesToWhoWantsItFirst() {
    Attendance all;
    const ClientId reader = all.join("reader", "r", false, 0).value();
    QCOMPARE_EQ(all.pen(), ClientId(0));
    const ClientId writer = all.join("writer", "w", true, 0).value();
    const ClientId second = all.join("second", "s", true, 0).value();
    QCOMPARE_EQ(all.pen(), writer);
    COMPARE_CONTAINS(test::refusal(all.takePen(second)), "writer has the pen");
    COMPARE_CONTAINS(test::refusal(all.takePen(reader)), "writer has the pen");
    all.leave(writer);
    VERIFY_RESULT(all.takePen(reader));
    QCOMPARE_EQ(all.pen(), reader);
    QVERIFY(!all.takePen(writer)); // it has left
}

void TestAttendance::onlyTheHolderPassesIt() {
    Attendance all;
    const ClientId a = all.join("a", "1", true, 0).value(), b = all.join("b", "2", true, 0).value();
    QVERIFY(!all.passPen(b, "b"));
    QVERIFY(!all.passPen(a, "nobody"));
    QCOMPARE_EQ(all.pen(), a);
    VERIFY_RESULT(all.passPen(a, "b"));
    QCOMPARE_EQ(all.pen(), b);
    VERIFY_RESULT(all.passPen(b, ""));
    QCOMPARE_EQ(all.pen(), ClientId(0));
    QVERIFY(!all.passPen(0, "a")); // nobody cannot pass what nobody has
}

void TestAttendance::whoAsksWaitsForAnAnswer() {
    Attendance all;
    const ClientId a = all.join("a", "1", true, 0).value(), b = all.join("b", "2", false, 0).value();
    QCOMPARE_EQ(all.asker(), ClientId(0));
    QVERIFY(!all.takePen(b)); // an edit, for one, asks for nothing
    QCOMPARE_EQ(all.asker(), ClientId(0));
    all.ask(b);
    QCOMPARE_EQ(all.asker(), b);
    all.leave(b);
    QCOMPARE_EQ(all.asker(), ClientId(0));
    const ClientId c = all.join("c", "3", false, 0).value();
    all.ask(c);
    VERIFY_RESULT(all.passPen(a, "c"));
    QCOMPARE_EQ(all.asker(), ClientId(0));
    all.ask(a);
    all.leave(c); // the pen is free, and nobody has to be asked
    QCOMPARE_EQ(all.asker(), ClientId(0));
}

void TestAttendance::silenceTakesThePen() {
    Attendance all;
    const ClientId a = all.join("a", "1", true, 10).value();
    all.join("b", "2", false, 10).value();
    QVERIFY(!all.takeFromSilent(10 + 0.99 * kSilence));
    all.heard(a, 10.5);
    QVERIFY(!all.takeFromSilent(10.5 + 0.99 * kSilence));
    const auto silent = all.takeFromSilent(10.5 + 1.01 * kSilence);
    QCOMPARE_EQ(silent.value_or(0), a);
    QCOMPARE_EQ(all.pen(), ClientId(0));
    QVERIFY(!all.takeFromSilent(20)); // it is said once
    QVERIFY(all.find(a));             // it attends still, and may ask again
    VERIFY_RESULT(all.takePen(a));
}

void TestAttendance::keysTellClientsApart() {
    Attendance all;
    const ClientId a = all.join("a", "first key", false, 0).value();
    const ClientId b = all.join("b", "other key", false, 0).value();
    QCOMPARE_EQ(all.whoHas("first key"), a);
    QCOMPARE_EQ(all.whoHas("other key"), b);
    for (const char* wrong : {"", "first", "first kez", "first key "})
        QCOMPARE_EQ(all.whoHas(wrong), ClientId(0));
    all.leave(a);
    QCOMPARE_EQ(all.whoHas("first key"), ClientId(0));
}

void TestAttendance::namesAreSafeToPrint() {
    Attendance all;
    const ClientId a = all.join("x\x1b[31m\nFAKE LINE", "k", false, 0).value();
    COMPARE_LACKS(all.find(a)->name, "\x1b");
    COMPARE_LACKS(all.find(a)->name, "\n");
    const ClientId nameless = all.join("  ", "l", false, 0).value();
    COMPARE_CONTAINS(all.find(nameless)->name, "client");
}

void TestAttendance::noMoreThanCanAttend() {
    Attendance all;
    for (std::size_t i = 0; i < kMostClients; ++i)
        VERIFY_RESULT(all.join("a", std::to_string(i), false, 0));
    QVERIFY(!all.join("one more", "k", false, 0));
    all.leave(1);
    VERIFY_RESULT(all.join("one more", "k", false, 0));
}

void TestAttendance::secretsDifferAndCompare() {
    std::set<std::string> seen;
    for (int i = 0; i < 1000; ++i)
        seen.insert(makeSecret().value());
    QCOMPARE_EQ(seen.size(), std::size_t(1000));
    QCOMPARE_EQ(seen.begin()->size(), std::size_t(16));
    QCOMPARE(QString::fromStdString(hexOf(std::string("\x00\x7f\xff", 3))), QString("007fff"));
    QVERIFY(sameSecret("abc", "abc"));
    QVERIFY(!sameSecret("abc", "abd"));
    QVERIFY(!sameSecret("abc", "ab"));
    QVERIFY(!sameSecret("", "")); // no secret is nobody's secret
}

TACTUM_TEST(TestAttendance)

} // namespace test_attendance

#include "test_attendance.moc"
