// tactum serve, as a person starts it: what it says, what it refuses, and what the other programs do not
// carry for it.
#include <sys/stat.h>

#include <csignal>

#include <QRegularExpression>
#include <QTest>

#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_serve {

using namespace test_program;

namespace {

QByteArray librariesOf(const QString& program) {
    QProcess ldd;
    ldd.start("ldd", {program});
    ldd.waitForFinished(60000);
    return ldd.readAllStandardOutput();
}

} // namespace

class TestServe : public QObject, WorkFolder {
    Q_OBJECT

private slots:
    void saysWhereItListensAndEndsInOrder();
    void refusesWhatCannotBe_data();
    void refusesWhatCannotBe();
    void makesACertificateOnceForAll();
    void othersDoNotCarryTheNetwork();
};

void TestServe::saysWhereItListensAndEndsInOrder() {
    QProcess server;
    server.start(TACTUM_PROGRAM, {"serve", plate(), "--listen", "127.0.0.1:0"});
    QVERIFY(server.waitForStarted(60000));
    while (!server.canReadLine())
        QVERIFY(server.waitForReadyRead(60000));
    const QString line = QString::fromUtf8(server.readLine());
    QVERIFY2(QRegularExpression("^listening on 127\\.0\\.0\\.1:[1-9][0-9]*\n$").match(line).hasMatch(),
             qPrintable(line));
    QCOMPARE_EQ(::kill(pid_t(server.processId()), SIGTERM), 0);
    QVERIFY(server.waitForFinished(60000));
    QCOMPARE_EQ(server.exitCode(), 0);
    QCOMPARE(server.readAllStandardError(), QByteArray());
}

void TestServe::refusesWhatCannotBe_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("code");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* name, const QStringList& words, int code, const char* says) {
        QTest::newRow(name) << words << code << QByteArray(says);
    };
    row("others could reach it", {"--listen", "0.0.0.0:0", "--credentials", "/nowhere"}, 1,
        "--make-certificate");
    row("no port", {"--listen", "127.0.0.1"}, 2, "HOST:PORT");
    row("no such port", {"--listen", "127.0.0.1:99999"}, 2, "HOST:PORT");
    row("no address of ours", {"--listen", "192.0.2.1:0", "--credentials", "/nowhere"}, 1,
        "--make-certificate");
    row("no such scene", {"/nowhere/a.obj"}, 1, "a.obj");
    row("no such device", {"--device", "spoon"}, 1, "spoon");
    row("one device for two hands", {"--device", "falcon:1-1", "--device", "falcon:1-1"}, 1, "named twice");
    row("too many hands",
        {"--device", "simulated", "--device", "simulated", "--device", "simulated", "--device", "simulated",
         "--device", "simulated"},
        1, "4 hands");
    row("too much force", {"--outside-force", "1e9"}, 2, "0 to 100");
    row("no such option", {"--nonsense"}, 2, "--help");
}

void TestServe::refusesWhatCannotBe() {
    QFETCH(QStringList, words);
    QFETCH(int, code);
    QFETCH(QByteArray, says);
    const Ended ended = runTactum(QStringList{"serve"} + words);
    COMPARE_CONTAINS(oneLine(ended.error), says);
    QCOMPARE_EQ(ended.code, code);
    QCOMPARE(ended.out, QByteArray());
}

void TestServe::makesACertificateOnceForAll() {
    const QString place = file("server");
    const Ended made =
        runTactum({"serve", "--credentials", place, "--make-certificate", "haptics.lab", "10.0.0.7"});
    QCOMPARE(made.error, QByteArray());
    QCOMPARE_EQ(made.code, 0);
    QProcess openssl;
    openssl.start("openssl", {"x509", "-in", place + "/certificate.pem", "-noout", "-ext", "subjectAltName"});
    if (openssl.waitForFinished(60000)) { // where there is one
        const QByteArray names = openssl.readAllStandardOutput();
        COMPARE_CONTAINS(names, QByteArray("DNS:haptics.lab"));
        COMPARE_CONTAINS(names, QByteArray("IP Address:10.0.0.7"));
    }
    COMPARE_CONTAINS(runTactum({"serve", "--credentials", place, "--make-certificate", "a b"}).error,
                     QByteArray("no name"));
    const auto key = [&] {
        QFile kept(place + "/key.pem");
        return kept.open(QIODevice::ReadOnly) ? kept.readAll() : QByteArray();
    };
    const QByteArray before = key();
    const Ended again = runTactum({"serve", "--credentials", place, "--make-certificate"});
    COMPARE_CONTAINS(again.error, QByteArray("is there already"));
    QCOMPARE_EQ(again.code, 1);
    QVERIFY(!before.isEmpty());
    QCOMPARE(key(), before);
    // What does not belong together, and what is none of it, is seen before anybody listens.
    const QString other = file("other");
    QCOMPARE_EQ(runTactum({"serve", "--credentials", other, "--make-certificate"}).code, 0);
    const auto started = [&] {
        return runTactum({"serve", "--listen", "0.0.0.0:0", "--credentials", other});
    };
    QVERIFY(QFile::remove(other + "/key.pem") && QFile::copy(place + "/key.pem", other + "/key.pem"));
    COMPARE_CONTAINS(oneLine(started().error), QByteArray("key.pem: belongs to another certificate"));
    QVERIFY(QFile::remove(other + "/key.pem"));
    QCOMPARE_EQ(mkfifo(qPrintable(other + "/key.pem"), 0600), 0); // which would never end
    COMPARE_CONTAINS(oneLine(started().error), QByteArray("key.pem: cannot be read"));
    QFile certificate(other + "/certificate.pem");
    QVERIFY(certificate.open(QIODevice::WriteOnly) && certificate.write("garbage") == 7);
    certificate.close();
    QVERIFY(QFile::remove(other + "/key.pem") && QFile::copy(place + "/key.pem", other + "/key.pem"));
    COMPARE_CONTAINS(oneLine(started().error), QByteArray("certificate.pem: is no certificate"));
    QCOMPARE(started().out, QByteArray());
    COMPARE_CONTAINS(
        runTactum({"serve", "--credentials", file("typo"), "--make-certificate", "999.1.1.1"}).error,
        QByteArray("no name or address"));
}

void TestServe::othersDoNotCarryTheNetwork() {
    const QString program = TACTUM_PROGRAM;
    for (const QString& other : {program, program + "-import"}) {
        const QByteArray libraries = librariesOf(other);
        COMPARE_CONTAINS(libraries, QByteArray("libc.so"));
        COMPARE_LACKS(libraries, QByteArray("libgrpc"));
        COMPARE_LACKS(libraries, QByteArray("libprotobuf"));
    }
    COMPARE_CONTAINS(librariesOf(program + "-serve"), QByteArray("libgrpc"));
    COMPARE_LACKS(librariesOf(program + "-serve"), QByteArray("libQt6"));
}

TACTUM_TEST(TestServe)

} // namespace test_serve

#include "test_serve.moc"
