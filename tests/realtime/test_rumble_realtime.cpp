// The proof that a gamepad that vibrates costs the loops nothing: no hit of the interposer inside a
// RealtimeScope while one is told what bumps feel like.
#include <QTest>

#include "core/base/realtime.h"
#include "core/haptics/compile.h"
#include "core/runtime/local_engine.h"
#include "device/simulated_hand.h"
#include "tests/core/runtime/patience.h"
#include "tests/realtime/bumpy_scene.h"
#include "tests/realtime/interposer.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/rumble/virtual_pad.h"
#include "ui/rumble/rumble_link.h"

namespace test_rumble_realtime {

using namespace tactum;
using namespace tactum::test;

class TestRumbleRealtime : public QObject {
    Q_OBJECT
private slots:
    void theLoopsKnowNothingOfIt() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        const auto target = std::make_shared<HandTarget>();
        LocalEngine engine(std::make_unique<SimulatedHand>(target));
        engine.publish(compile(bumpyScene(bumpyPlate(1), 1)).value());
        interposer::reset();
        QVERIFY(engine.start().has_value());
        engine.setAllArmed(true);
        link.setOn(true);
        std::uint64_t frames = 0, told = 0;
        std::vector<TracePoint> points;
        const bool ran = eventually([&] {
            engine.poll();
            target->write({.position = wanderingFinger(4e-3 * double(++frames))});
            if (frames % 500 == 0) link.setOn(!link.on());
            points.clear();
            for (TracePoint point; engine.popTrace(point);)
                points.push_back(point);
            link.play(points, engine.device().rate);
            told = pad.told().size();
            return told > 100 && engine.servo().ticks >= 3000;
        });
        link.setOn(false);
        engine.stop();
        QVERIFY(ran);
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
    }
};

TACTUM_TEST(TestRumbleRealtime)

} // namespace test_rumble_realtime

#include "test_rumble_realtime.moc"
