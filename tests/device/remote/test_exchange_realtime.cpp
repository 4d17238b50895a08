// The proof that exchange() of a remote device and of the makers' drivers neither allocates nor locks nor
// waits: no hit of the interposer.
#include <QTest>

#include "core/base/realtime.h"
#include "device/remote/remote_device.h"
#include "device/vendor/force_dimension.h"
#include "device/vendor/open_haptics.h"
#include "tests/device/remote/served_device.h"
#include "tests/realtime/interposer.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_exchange_realtime {

using namespace tactum;
using namespace tactum::test;

class TestExchangeRealtime : public QObject {
    Q_OBJECT

    static Result<DeviceInfo> figures(std::string_view) {
        return DeviceInfo{.name = "Example", .maxForce = 3};
    }

    static void exchangeThousands(HapticDevice& device) {
        const auto opened = device.open();
        VERIFY_RESULT(opened);
        QTest::qWait(50); // its first readings
        interposer::reset();
        // Thousands take less than a busy machine lets who answers them wait.
        const bool read = eventually([&] {
            int valid = 0;
            for (int i = 0; i < 10'000; ++i) {
                const RealtimeScope scope;
                valid += device.exchange({{0.1, 0, 0.1}}, 1e-3).valid;
            }
            return valid > 0;
        });
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        QVERIFY2(read, "no valid reading");
        device.emergencyStop();
    }

private slots:
    void initTestCase() {
        // It notices what is to be noticed.
        interposer::reset();
        {
            const RealtimeScope scope;
            // By a pointer: the compiler takes a plain malloc for one that looks at nothing.
            void* (*volatile allocate)(std::size_t) = std::malloc;
            void* memory = allocate(1);
            std::free(memory);
        }
        QCOMPARE_GT(interposer::hits(), 0);
    }

    void ofARemoteDevice() {
        QTemporaryDir dir;
        const std::string file = dir.filePath("served").toStdString();
        QVERIFY(mapServed(file.c_str()));
        const auto device = makeRemoteDevice(TACTUM_REMOTE_PROGRAM, {"serve", file, ""});
        VERIFY_RESULT(device);
        exchangeThousands(**device);
    }

    void ofOpenHaptics() {
        qputenv("TACTUM_LIBHD", TACTUM_FAKE_HD);
        exchangeThousands(**makeOpenHaptics("openhaptics:default", figures));
    }

    void ofForceDimension() {
        qputenv("TACTUM_LIBDHD", TACTUM_FAKE_DHD);
        exchangeThousands(**makeForceDimension("forcedimension:0", figures));
    }
};

TACTUM_TEST(TestExchangeRealtime)

} // namespace test_exchange_realtime

#include "test_exchange_realtime.moc"
