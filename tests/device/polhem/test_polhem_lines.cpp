// What a Polhem is told, to the byte; its motors' limits; and a port that is full.
#include <cmath>
#include <limits>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <QTest>

#include "device/polhem/polhem_arm.h"
#include "device/polhem/polhem_lines.h"
#include "device/polhem/serial_port.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_polhem_lines {

using namespace tactum;
using namespace tactum::test;

class TestPolhemLines : public QObject {
    Q_OBJECT

    const PolhemArm arm_;

private slots:
    /// uhaptikfabriken.h 0.2: 64 bytes, numbers, blanks, a line feed; newtons are thousands.
    void aForceIsALineOf64Bytes() {
        const std::string line(forceLine({1.2345, -0.5, 2}));
        QCOMPARE(line.size(), 64U);
        QCOMPARE(line, "2000 1235 -500 2 0 0 0" + std::string(41, ' ') + "\n");
        const std::string wild(forceLine({std::nan(""), 1e300, -1e300}));
        QVERIFY2(wild.starts_with("-30000 0 30000 2 0 0 0 "), wild.c_str()); // what fits into 16 bits
    }

    /// hfab_protocol.h and PJRCSerialComm::send() of API 0.5: at least 16 bytes.
    void aCurrentIsALineInBrackets() {
        using namespace std::literals;
        QCOMPARE(std::string(currentLine({0, -0.25, 0})), "[0,-250,0]\n\0\0\0\0\0"s);
        QCOMPARE(std::string(currentLine({-2.999, 2.5, 1.0006})), "[-2999,2500,1001]\n"s);
    }

    void whatIsTooLongIsNoLine() {
        PolhemReader reader;
        std::vector<std::string> lines;
        const auto take = [&](const std::string& bytes) {
            reader.take(bytes, [&](std::string_view line) { lines.emplace_back(line); });
        };
        const std::string longest(128, 'a');
        take("1 2\r\n3 ");
        take("4\n" + longest + "\n" + longest + "b\n");
        take(std::string(100'000, 'c'));
        take("c\n5\n");
        QCOMPARE(lines, (std::vector<std::string>{"1 2", "3 4", longest, "5"}));
    }

    void noMotorGetsMoreThanItsLimit() {
        const Vec3 joints = jointsOf(arm_, {-8312 + 200, 4500, -12000, 0, 0, 0});
        QVERIFY(positionOf(arm_, joints));
        const Vec3 held = currentsFor(arm_, Vec3::Zero(), joints),
                   little = currentsFor(arm_, {0.1, 0.2, -0.1}, joints);
        const Vec3 most = currentsFor(arm_, 1000 * Vec3(0.1, 0.2, -0.1), joints);
        QVERIFY(held.norm() > 0.1); // its own weight
        QCOMPARE_LE(most.cwiseAbs().maxCoeff(), arm_.maxCurrent + 1e-12);
        QCOMPARE_GT(most.cwiseAbs().maxCoeff(), 0.9 * arm_.maxCurrent);
        const Vec3 way = (little - held).normalized(), strong = (most - held).normalized();
        QCOMPARE_GT(way.dot(strong), 1 - 1e-9); // in the same direction
    }

    void whereNoArmIsNothingIsPushed() {
        const double inf = std::numeric_limits<double>::infinity();
        const Vec3 there = jointsOf(arm_, {0, 0, 0, 0, 0, 0});
        QVERIFY(positionOf(arm_, there));
        QCOMPARE(currentsFor(arm_, {std::nan(""), 0, 0}, there), Vec3(0, 0, 0));
        for (const Vec3& nowhere : {Vec3(0, M_PI, M_PI), Vec3(0, std::nan(""), 0), Vec3(0, 0, inf)}) {
            QVERIFY(!positionOf(arm_, nowhere));
            QCOMPARE(currentsFor(arm_, {0, 0, 1}, nowhere), Vec3(0, 0, 0));
        }
    }

    /// A board that does not listen fills its port: what it reads then are whole lines, and nothing that two
    /// made.
    void aFullPortMakesNoLineOfTwo() {
        const int board = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
        QVERIFY(board >= 0 && grantpt(board) == 0 && unlockpt(board) == 0);
        auto port = SerialPort::open(ptsname(board));
        VERIFY_RESULT(port);
        std::string sent, heard;
        int refused = 0;
        for (int i = 0; refused < 3; ++i) {
            QVERIFY(i < 100'000);
            const std::string line = "[" + std::to_string(i) + ",7,-7]\n";
            if ((*port)->send(line))
                sent += line;
            else
                ++refused;
        }
        for (Patience patience; heard.size() < sent.size() && !patience.isOver();) {
            std::array<char, 1000> room{};
            const ssize_t count = read(board, room.data(), room.size());
            if (count > 0) heard.append(room.data(), std::size_t(count));
            if (heard.size() < sent.size() && (*port)->send("[0,0,0]\n")) sent += "[0,0,0]\n";
        }
        QVERIFY2(heard == sent, qPrintable(QString("%1 of %2 bytes").arg(heard.size()).arg(sent.size())));
        port->reset();
        ::close(board);
    }
};

TACTUM_TEST(TestPolhemLines)

} // namespace test_polhem_lines

#include "test_polhem_lines.moc"
