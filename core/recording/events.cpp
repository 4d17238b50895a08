#include "core/recording/events.h"

#include <algorithm>

#include "core/safety/inhibit_words.h"

namespace tactum {
namespace {

using Events = std::vector<RecordedEvent>;

const char* wordsFor(Fidelity fidelity) {
    switch (fidelity) {
    case Fidelity::Full:
        return "nothing is left out any more";
    case Fidelity::NoTexture:
        return "too slow: without texture";
    case Fidelity::NoShading:
        return "too slow: without texture and shading";
    case Fidelity::PlaneOnly:
        return "too slow: the plane alone";
    }
    return "an unknown fidelity";
}

void addGuard(Events& events, const ServoRow& before, const ServoRow& now) {
    const bool armed = now.flags & ServoRow::Armed;
    if (armed != bool(before.flags & ServoRow::Armed))
        events.push_back({now.time, false, armed ? "forces on" : "forces off"});
    if (now.inhibit == before.inhibit) return;
    const auto why = InhibitReason(now.inhibit);
    // Off and on again are the person's own doing, and said above.
    const bool ordinary =
        why == InhibitReason::NotArmed || why == InhibitReason::Settling || why == InhibitReason::Rising;
    if (!ordinary) events.push_back({now.time, isFault(why), inhibitWords(why).brief});
}

void addDevice(Events& events, const ServoRow& before, const ServoRow& now) {
    if (now.oscillations > before.oscillations)
        events.push_back({now.time, false, "an oscillation was noticed: less stiffness"});
    if ((now.flags & ServoRow::Jumped) && !(before.flags & ServoRow::Jumped))
        events.push_back({now.time, false, "the finger was put elsewhere"});
    if (!(now.flags & ServoRow::Valid) && (before.flags & ServoRow::Valid))
        events.push_back({now.time, false, "the device did not answer"});
}

/// Of what all hands share.
void addScene(Events& events, const ProxyRow& before, const ProxyRow& now) {
    if (now.world != before.world) events.push_back({now.time, false, "the scene was edited"});
    if (now.flags & ProxyRow::Begin) events.push_back({now.time, false, "the bodies began anew"});
    if (now.fidelity() != before.fidelity()) events.push_back({now.time, false, wordsFor(now.fidelity())});
}

void addProxy(Events& events, const ProxyRow& now) {
    if (now.flags & ProxyRow::Found) events.push_back({now.time, false, "the finger was found anew"});
    if (now.flags & ProxyRow::Restart) events.push_back({now.time, false, "the proxy was put on the finger"});
}

Events eventsOf(const HandRecord& hand) {
    Events events;
    for (std::size_t i = 1; i < hand.servo.rows.size(); ++i) {
        addGuard(events, hand.servo.rows[i - 1], hand.servo.rows[i]);
        addDevice(events, hand.servo.rows[i - 1], hand.servo.rows[i]);
    }
    for (std::size_t i = 1; i < hand.proxy.rows.size(); ++i)
        addProxy(events, hand.proxy.rows[i]);
    return events;
}

} // namespace

std::vector<RecordedEvent> eventsOf(const RecordedRun& run) {
    Events events;
    for (std::size_t i = 0; i < run.hands(); ++i)
        for (RecordedEvent& event : eventsOf(run.hand(i))) {
            if (run.hands() > 1) event.text = "hand " + std::to_string(i + 1) + ": " + event.text;
            events.push_back(std::move(event));
        }
    for (std::size_t i = 1; i < run.proxy.rows.size(); ++i)
        addScene(events, run.proxy.rows[i - 1], run.proxy.rows[i]);
    std::ranges::stable_sort(events, {}, &RecordedEvent::time);
    return events;
}

} // namespace tactum
