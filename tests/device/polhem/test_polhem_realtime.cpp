// What an exchange with a Polhem costs in the servo: one read of its port and one write, and nothing else.
#include <QTest>

#include "core/base/realtime.h"
#include "device/polhem/polhem.h"
#include "tests/device/polhem/fake_polhem.h"
#include "tests/realtime/interposer.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_polhem_realtime {

using namespace tactum;
using namespace tactum::test;

class TestPolhemRealtime : public QObject {
    Q_OBJECT

private slots:
    void itReadsAndWritesAndThatIsAll_data() {
        QTest::addColumn<int>("firmware");
        QTest::newRow("forces") << int(FakePolhem::Firmware::Of2020);
        QTest::newRow("currents") << int(FakePolhem::Firmware::Of2023);
    }
    void itReadsAndWritesAndThatIsAll() {
        QFETCH(int, firmware);
        FakePolhem board{FakePolhem::Firmware(firmware)};
        const auto device = makePolhem("polhem:polhem", {.name = "Polhem", .maxForce = 5}).value();
        VERIFY_RESULT(device->open());
        int read = 0;
        for (int i = 0; i < 3000 || read < 100; ++i) {
            QVERIFY(i < 1'000'000);
            interposer::reset();
            DeviceSample sample;
            {
                const RealtimeScope scope;
                sample = device->exchange({{0.1, 0, 0.1}}, 1e-3);
            }
            read += sample.valid;
            QVERIFY2(interposer::hits() <= 2, interposer::firstHit().c_str());
            QCOMPARE_GE(interposer::hits(), sample.valid ? 2U : 1U); // they are counted at all
        }
    }
};

TACTUM_TEST(TestPolhemRealtime)

} // namespace test_polhem_realtime

#include "test_polhem_realtime.moc"
