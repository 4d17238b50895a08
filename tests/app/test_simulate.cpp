// tactum simulate, driven from outside: its columns, options and numbers.
//
// What would show that a test here is wrong: the falls, spins and swings that are expected are those of a
// formula, in a file that says nothing about this program.

#include <cmath>

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "tests/app/keyed_pusher.h"
#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_simulate {

using namespace test_program;

namespace {

constexpr const char* kHeader = "t,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,kinetic,potential";

struct StateRow {
    double t = 0;
    QString body;
    QList<double> numbers; ///< from x on
    double operator[](int column) const { return numbers.value(column); }
};
enum { X, Y, Z, Qw, Qx, Qy, Qz, Vx, Vy, Vz, Wx, Wy, Wz, Kinetic, Potential };

QList<StateRow> rowsOf(const QByteArray& csv) {
    QList<StateRow> rows;
    for (const QByteArray& line : csv.split('\n').mid(1)) {
        const QList<QByteArray> cells = line.split(',');
        if (cells.size() != 17) continue;
        StateRow row{cells[0].toDouble(), cells[1], {}};
        for (const QByteArray& cell : cells.mid(2))
            row.numbers.append(cell.toDouble());
        rows.append(row);
    }
    return rows;
}

QByteArray gltf(const QByteArray& nodes, const QByteArray& extensions = "{}") {
    return R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_physics_rigid_bodies","KHR_implicit_shapes"],)"
           R"("scenes":[{"nodes":[0,1]}],"extensions":)" +
           extensions + R"(,"nodes":)" + nodes + "}";
}

constexpr const char* kBall =
    R"([{"name":"ball","translation":[1,2,3],"extensions":{"KHR_physics_rigid_bodies":{"motion":)"
    R"({"mass":0.5,"inertiaDiagonal":[1,1,1],"linearVelocity":[0.5,0,0]}}}},{"name":"nothing"}])";

} // namespace

class TestSimulate : public QObject, WorkFolder {
    Q_OBJECT

private slots:
    void aBodyFalls() {
        const QString scene = write("fall.gltf", gltf(kBall));
        const Ended run =
            runTactum({"simulate", scene, "--seconds", "0.5", "--out", "-", "--summary", file("s.json")});
        QCOMPARE(run.code, 0);
        QVERIFY(run.out.startsWith(QByteArray(kHeader) + '\n'));
        const QList<StateRow> rows = rowsOf(run.out);
        QCOMPARE(rows.size(), 51); // every 10 ms, the start too
        QCOMPARE(rows[0].body, QString("ball"));
        QCOMPARE(rows[0][Y], 2.0);
        for (const StateRow& row : rows) {
            COMPARE_NEAR(row[X], 1 + 0.5 * row.t, 1e-12, "m");
            COMPARE_NEAR(row[Y], 2 - 0.5 * 9.81 * row.t * row.t, 1e-11, "m");
            COMPARE_NEAR(row[Vy], -9.81 * row.t, 1e-11, "m/s");
            COMPARE_NEAR(row[Potential], 0.5 * 9.81 * row[Y], 1e-9, "J");
            COMPARE_NEAR(row[Kinetic], 0.25 * (0.25 + row[Vy] * row[Vy]), 1e-9, "J");
        }
        QFile in(file("s.json"));
        QVERIFY(in.open(QIODevice::ReadOnly));
        const QJsonObject summary = QJsonDocument::fromJson(in.readAll()).object();
        QCOMPARE(summary["bodies"].toInt(), 1);
        for (const char* key : {"mean", "median", "p99", "p999", "max"})
            QVERIFY2(summary["step_ns"].toObject()[key].toDouble() > 0, key);
        QVERIFY(summary["energy_drift"].toDouble() < 1e-9);
    }

    void gravityAndRateAreTheirs() {
        const QString scene = write("fall.gltf", gltf(kBall));
        const Ended run = runTactum({"simulate", scene, "--seconds", "1", "--rate", "100", "--every", "0.5",
                                     "--gravity", "0,0,-2", "--out", "-"});
        const QList<StateRow> rows = rowsOf(run.out);
        QCOMPARE(rows.size(), 3);
        COMPARE_NEAR(rows[2][Z], 3 - 1.0, 1e-11, "m");
        COMPARE_NEAR(rows[2][Y], 2, 1e-12, "m");
    }

    // Off its centre: it turns, and the force goes with the point.
    void aPushActsWhereItIs() {
        const QString scene = write("push.gltf", gltf(kBall));
        const Ended run = runTactum({"simulate", scene, "--seconds", "0.2", "--gravity", "0,0,0", "--push",
                                     "0,0.1,1,2.1,3,0,0,3", "--every", "0.1", "--out", "-"});
        const QList<StateRow> rows = rowsOf(run.out);
        COMPARE_NEAR(rows[1][Vz], 3 * 0.1 / 0.5, 1e-9, "m/s");
        COMPARE_NEAR(rows[2][Vz], 3 * 0.1 / 0.5, 1e-9, "m/s"); // it has ended
        COMPARE_NEAR(rows[1][Wx], 0.1 * 3 * 0.1 / 1, 2e-5, "rad/s");
    }

    // Three of one name, one of which is called as the second would be.
    void bodiesOfOneNameAreToldApart() {
        QByteArray nodes;
        for (const char* name : {"box", "box", "box 2", "box"})
            nodes += QByteArray(",{'name':'") + name +
                     "','extensions':{'KHR_physics_rigid_bodies':{'motion':{'mass':1}}}}";
        QByteArray text = gltf("[" + nodes.mid(1).replace('\'', '"') + "]");
        text.replace("[0,1]", "[0,1,2,3]");
        const Ended run =
            runTactum({"simulate", write("boxes.gltf", text), "--seconds", "0.01", "--out", "-"});
        QStringList names;
        for (const StateRow& row : rowsOf(run.out).first(4))
            names << row.body;
        QCOMPARE(names, QStringList({"box", "box 3", "box 2", "box 4"}));
    }

    // Its ends fall between two steps: the bodies get all of its impulse and no more.
    void aPushBetweenStepsIsWhole() {
        const QString scene = write("push.gltf", gltf(kBall));
        const Ended run =
            runTactum({"simulate", scene, "--seconds", "0.1", "--gravity", "0,0,0", "--push",
                       "0.0301,0.0302,1,2,3,0,0,3", "--rate", "100", "--every", "0.1", "--out", "-"});
        COMPARE_NEAR(rowsOf(run.out)[1][Vz], 3 * 0.0001 / 0.5, 1e-12, "m/s");
        COMPARE_NEAR(rowsOf(run.out)[1][Z], 3 + 3 * 0.0001 / 0.5 * (0.1 - 0.03015), 1e-12, "m");
    }

    // An animation leads a body, whose box meets a loose one.
    void aBodyOnKeysPushesWhatItMeets() {
        const Ended run = runTactum({"simulate", write("keys.gltf", keyedPusher()), "--seconds", "1.5",
                                     "--gravity", "0,0,0", "--every", "0.1", "--out", "-"});
        QCOMPARE(run.code, 0);
        for (const StateRow& row : rowsOf(run.out)) {
            if (row.body == "pusher") {
                COMPARE_NEAR(row[X], -1 + row.t, 1e-6, "m"); // the file is in single precision
                COMPARE_NEAR(row[Vx], 1, 1e-6, "m/s");
            } else { // they touch once the pusher has come 0.8 m
                COMPARE_NEAR(row[X], std::max(0.0, row.t - 0.8), 1e-4, "m");
                COMPARE_NEAR(row[Qw], 1, 1e-6, "");
            }
        }
    }

    // What its keys put elsewhere was not on the way there.
    void aBodyThatJumpsPushesNobody() {
        const Ended run = runTactum({"simulate", write("keys.gltf", keyedPusher("STEP")), "--seconds", "2.5",
                                     "--gravity", "0,0,0", "--every", "0.1", "--out", "-"});
        QCOMPARE(run.code, 0);
        const QList<StateRow> rows = rowsOf(run.out);
        QCOMPARE(rows.size(), 52);
        for (const StateRow& row : rows) {
            const bool jumped = row.t > 2.05; // at 2 s itself either place is right
            if (row.body == "loose")
                COMPARE_NEAR(row[X], 0, 1e-12, "m");
            else if (jumped || row.t < 1.95)
                COMPARE_NEAR(row[X], jumped ? 1 : -1, 1e-6, "m");
        }
    }

    // Who sees only zeros in the table would take them for rest.
    void whatNumbersDoNotHoldIsSaid() {
        const QString scene =
            write("wild.gltf", gltf(R"([{"name":"ball","extensions":{"KHR_physics_rigid_bodies":{)"
                                    R"("motion":{"mass":1,"inertiaDiagonal":[1,2,3],)"
                                    R"("angularVelocity":[1e9,-1e9,1e9]}}}},{"name":"nothing"}])"));
        const Ended run = runTactum({"simulate", scene, "--seconds", "0.1", "--every", "0.1", "--out", "-"});
        QCOMPARE(run.code, 1);
        COMPARE_CONTAINS(oneLine(run.error), QByteArray("speeds went beyond what numbers hold"));
        QCOMPARE(rowsOf(run.out).size(), 2);
    }

    void rowsEndWithTheTime() {
        const QString scene = write("fall.gltf", gltf(kBall));
        const Ended run = runTactum({"simulate", scene, "--seconds", "1", "--every", "0.6", "--out", "-"});
        QCOMPARE(rowsOf(run.out).size(), 2); // at 0 and 0.6, and none after the end
    }

    void noMoreRowsThanAMachineHolds() {
        const QString scene = write("fall.gltf", gltf(kBall));
        const Ended run = runTactum({"simulate", scene, "--seconds", "1e5", "--rate", "1e6"});
        QCOMPARE(run.code, 1);
        COMPARE_CONTAINS(oneLine(run.error), QByteArray("--seconds: that would be more"));
    }

    void whatWouldDoNothingIsRefused() {
        const QString scene = write("fall.gltf", gltf(kBall));
        const Ended never = runTactum({"simulate", scene, "--seconds", "0.1", "--every", "0.2"});
        QCOMPARE(never.code, 1);
        COMPARE_CONTAINS(oneLine(never.error), QByteArray("--seconds: is shorter than --every"));
        for (const char* when : {"0.1,0.2", "0.101,0.104", "-1,0"}) {
            const QString push = QStringLiteral("--push=%1,1,2,3,1,0,0").arg(when);
            const Ended late = runTactum({"simulate", scene, "--seconds", "0.105", push});
            QCOMPARE(late.code, 1);
            COMPARE_CONTAINS(oneLine(late.error),
                             QByteArray("is over before the first step or begins after"));
        }
    }

    // The lever is as long as it is asked for, and who did not mean that is told.
    void aPushBesideEveryBodyIsSaid() {
        const QString scene = write("fall.gltf", gltf(kBall));
        const auto errorOf = [&](const QString& push) {
            const Ended run = runTactum({"simulate", scene, "--seconds", "0.1", "--push", push});
            return run.code == 0 ? run.error : QByteArray("it failed");
        };
        QCOMPARE(errorOf(QStringLiteral("0,0.1,1,2,3,1,0,0")), QByteArray());
        COMPARE_CONTAINS(errorOf(QStringLiteral("0,0.1,1,2.5,3,1,0,0")), QByteArray("\"ball\", 0.5 m away"));
    }

    void theSameBits() {
        const QString scene = write("fall.gltf", gltf(kBall));
        const QStringList arguments{"simulate",        scene,   "--seconds", "0.3", "--push",
                                    "0,1,1,2,3,1,2,3", "--out", "-"};
        QCOMPARE(runTactum(arguments).out, runTactum(arguments).out);
    }

    void wrongUsageIsSaid_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("no time") << QStringList{} << QByteArray("--seconds");
        QTest::newRow("a push of seven")
            << QStringList{"--seconds", "1", "--push", "0,1,2,3,4,5,6"} << QByteArray("is not 8 numbers");
        QTest::newRow("a push with a comma too many")
            << QStringList{"--seconds", "1", "--push", "0,1,2,3,4,5,6,7,"} << QByteArray("is not 8 numbers");
        QTest::newRow("a push that ends before it begins")
            << QStringList{"--seconds", "1", "--push", "1,0,2,3,4,5,6,7"}
            << QByteArray("ends before it begins");
        QTest::newRow("a push beyond all forces")
            << QStringList{"--seconds", "1", "--push", "0,1,0,5,0,1e300,0,0"}
            << QByteArray("is not 8 numbers");
        QTest::newRow("gravity") << QStringList{"--seconds", "1", "--gravity", "0,x,1"}
                                 << QByteArray("is not 3 numbers");
        QTest::newRow("rate") << QStringList{"--seconds", "1", "--rate", "0"}
                              << QByteArray("is not a number from 1");
    }
    void wrongUsageIsSaid() {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, says);
        const QString scene = write("fall.gltf", gltf(kBall));
        const Ended run = runTactum(QStringList{"simulate", scene} + options);
        QCOMPARE(run.code, 2);
        COMPARE_CONTAINS(oneLine(run.error), says);
    }

    void aSceneWithoutBodiesIsRefused() {
        const Ended run = runTactum({"simulate", plate(), "--seconds", "1"});
        QCOMPARE(run.code, 1);
        COMPARE_CONTAINS(oneLine(run.error), QByteArray("has no body that moves by forces"));
    }
};

TACTUM_TEST(TestSimulate)

} // namespace test_simulate

#include "test_simulate.moc"
