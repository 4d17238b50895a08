// tactum touch with several hands, driven from outside: what each feels, and what they hold between them.
#include <array>
#include <cmath>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_touch_hands {

using namespace test_program;

namespace {

constexpr double kMass = 0.05, kHalf = 0.02, kRadius = 0.005;

using Row = QList<double>;
enum { T, FingerX, FingerY, FingerZ, ProxyX, ProxyY, ProxyZ, ForceX, ForceY, ForceZ, Contacts };

/// All but what differs from run to run: how long an update took.
QList<Row> rowsOf(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly)) return {};
    QList<Row> rows;
    for (const QByteArray& line : file.readAll().split('\n').mid(1)) {
        Row row;
        for (const QByteArray& cell : line.split(',').first(line.isEmpty() ? 0 : 11))
            row.append(cell.toDouble());
        if (!row.isEmpty()) rows.append(row);
    }
    return rows;
}

/// A loose cube in the origin, over nothing.
QByteArray looseBox() {
    QByteArray bytes;
    const auto add = [&bytes](const auto& number) {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            add(float(corner >> axis & 1 ? kHalf : -kHalf));
    for (const std::array<quint16, 4>& q : {std::array<quint16, 4>{0, 4, 6, 2},
                                            {1, 3, 7, 5},
                                            {0, 1, 5, 4},
                                            {2, 6, 7, 3},
                                            {0, 2, 3, 1},
                                            {4, 5, 7, 6}})
        for (const int i : {0, 1, 2, 0, 2, 3})
            add(q[std::size_t(i)]);
    const QByteArray text =
        "{'asset':{'version':'2.0'},'extensionsUsed':['KHR_physics_rigid_bodies'],'scene':0,"
        "'scenes':[{'nodes':[0]}],'nodes':[{'name':'box','mesh':0,'extensions':"
        "{'KHR_physics_rigid_bodies':{'motion':{'mass':0.05,'inertiaDiagonal':[1e-5,1e-5,1e-5]}}}}],"
        "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'indices':1}]}],'accessors':["
        "{'bufferView':0,'componentType':5126,'count':8,'type':'VEC3','min':[-0.02,-0.02,-0.02],"
        "'max':[0.02,0.02,0.02]},{'bufferView':1,'componentType':5123,'count':36,'type':'SCALAR'}],"
        "'bufferViews':[{'buffer':0,'byteLength':96},{'buffer':0,'byteOffset':96,'byteLength':72}],"
        "'buffers':[{'byteLength':168,'uri':'data:application/octet-stream;base64,@'}]}";
    return QByteArray(text).replace('\'', '"').replace("@", bytes.toBase64());
}

/// A finger that goes into a side of the box within 20 ms, and stays there for `seconds`.
QByteArray intoSide(int side, double depth, double seconds) {
    QByteArray text = "t,x,y,z\n";
    for (int i = 0; i <= int(std::lround(1000 * seconds)); ++i) {
        const double x = side * (kHalf + kRadius + 1e-3 - (depth + 1e-3) * std::min(1.0, i / 20.0));
        text += QByteArray::number(i * 1e-3, 'g', 17) + ',' + QByteArray::number(x, 'g', 17) + ",0,0\n";
    }
    return text;
}

} // namespace

class TestTouchHands : public QObject, WorkFolder {
    Q_OBJECT

private slots:
    // Over what stands still each feels what it would feel alone, to the last digit.
    void eachHandHasItsOwnRows() {
        const QString first = pressAndSlide(0.004, 0.01);
        QVERIFY(QFile::rename(first, file("first.csv")));
        QVERIFY(QFile::rename(pressAndSlide(0.002, 0.03), file("second.csv")));
        for (const char* name : {"first", "second"})
            QCOMPARE(runTactum({"touch", plate(), "--path", file(name) + ".csv", "--out",
                                file(name) + "-alone.csv", "--static-friction", "0.3"})
                         .code,
                     0);
        const Ended both =
            runTactum({"touch", plate(), "--path", file("first.csv"), "--path", file("second.csv"), "--out",
                       file("a.csv"), "--out", file("b.csv"), "--static-friction", "0.3"});
        QVERIFY2(both.code == 0, both.error);
        QCOMPARE(rowsOf(file("a.csv")).size(), 601);
        QCOMPARE(rowsOf(file("a.csv")), rowsOf(file("first-alone.csv")));
        QCOMPARE(rowsOf(file("b.csv")), rowsOf(file("second-alone.csv")));
        const QJsonArray hands = QJsonDocument::fromJson(both.out).object()["hands"].toArray();
        QCOMPARE(hands.size(), 2);
        COMPARE_CONTAINS(hands[1].toObject()["path"].toString(), "second.csv");
        int touching = 0;
        for (const Row& row : rowsOf(file("b.csv")))
            touching += row[Contacts] > 0;
        QCOMPARE(hands[1].toObject()["touching_updates"].toInt(), touching);
    }

    // The second path has other times, ends early, and rests then.
    void theFirstPathHasTheTimes() {
        const QString first = write("first.csv", "t,x,y,z\n0,0,0,0.02\n0.01,0,0,0.02\n0.02,0,0,0.02\n"
                                                 "0.03,0,0,0.02\n");
        const QString second = write("second.csv", "t,x,y,z\n0.005,0,0,0.03\n0.015,0.01,0,0.03\n");
        const Ended both = runTactum({"touch", plate(), "--path", first, "--path", second, "--out",
                                      file("a.csv"), "--out", file("b.csv")});
        QVERIFY2(both.code == 0, both.error);
        COMPARE_CONTAINS(both.error, "second.csv touches nothing");
        const QList<Row> rows = rowsOf(file("b.csv"));
        QCOMPARE(rows.size(), 4);
        const std::array<double, 4> x{0, 0.005, 0.01, 0.01};
        for (int i = 0; i < 4; ++i) {
            COMPARE_NEAR(rows[i][T], 0.01 * i, 1e-12, "s");
            COMPARE_NEAR(rows[i][FingerX], x[std::size_t(i)], 1e-12, "m");
        }
    }

    // Whatever it swings, over two seconds it gains no momentum: the fingers bore its weight.
    void twoHandsBearABox() {
        const QString box = write("box.gltf", looseBox());
        const Ended both =
            runTactum({"touch", box, "--path", write("l.csv", intoSide(-1, 2e-3, 2.2)), "--path",
                       write("r.csv", intoSide(1, 2e-3, 2.2)), "--out", file("a.csv"), "--out", file("b.csv"),
                       "--static-friction", "0.9", "--stiffness", "800", "--proxy-radius", "0.005"});
        QVERIFY2(both.code == 0, both.error);
        const QList<Row> left = rowsOf(file("a.csv")), right = rowsOf(file("b.csv"));
        QCOMPARE(left.size(), 2201);
        double sum = 0;
        for (int i = 201; i <= 2200; ++i)
            sum += left[i][ForceY] + right[i][ForceY];
        COMPARE_NEAR(sum / 2000, -kMass * 9.81, 0.01 * kMass * 9.81, "N");
        COMPARE_NEAR(left.last()[ForceX], -800 * 2e-3, 0.01, "N");
        COMPARE_NEAR(right.last()[ForceX], 800 * 2e-3, 0.01, "N");
    }
};

TACTUM_TEST(TestTouchHands)

} // namespace test_touch_hands

#include "test_touch_hands.moc"
