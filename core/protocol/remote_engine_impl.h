// What an engine at a server keeps, and what was ordered of it. For this folder.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <utility>

#include "core/protocol/remote_engine.h"
#include "core/protocol/remote_session.h"

namespace tactum {

/// What was set, which is told until the server had time to tell it.
template <class T> class Wish {
public:
    void set(const T& value) {
        value_ = value, until_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    }
    void forget() { until_ = {}; }
    T over(const T& told) const { return std::chrono::steady_clock::now() < until_ ? value_ : told; }

private:
    T value_{};
    std::chrono::steady_clock::time_point until_{};
};

/// What was ordered of a hand.
struct Wishes {
    Wish<bool> armed, deadMan, overrides;
    Wish<Workspace> workspace;

    void over(HandReport& told) const {
        told.armed = armed.over(told.armed);
        told.deadMan = deadMan.over(told.deadMan);
        told.overridesCeiling = overrides.over(told.overridesCeiling);
        told.workspace = workspace.over(told.workspace);
    }
};

struct RemoteEngine::Impl {
    Impl(RemoteSettings settings, std::shared_ptr<HandTarget> hand)
        : session(std::move(settings), std::move(hand)) {
        shown.hands.resize(1);
        shown.hands[0].device.name = "Haptic server";
    }

    HandReport& spokenHand() { return shown.hands[spoken]; }
    void order(v1::OrderRequest order, std::size_t hand, bool settles = false) {
        order.set_of(std::uint32_t(hand));
        session.order(std::move(order), settles);
    }
    void wishArmed(bool armed) {
        for (std::size_t hand = 0; hand < shown.hands.size(); ++hand)
            wishArmed(hand, armed);
    }
    void wishArmed(std::size_t hand, bool armed) {
        wishes[hand].armed.set(armed);
        shown.hands[hand].armed = armed && session.open();
    }
    /// Touch of the hand that is spoken of, and what all share.
    void join() {
        static_cast<TouchTelemetry&>(proxy) = spokenHand().touch;
        static_cast<WorldTelemetry&>(proxy) = shown.world;
    }

    RemoteSession session;
    EngineReport shown; ///< as poll() found it, with what was ordered since
    std::size_t spoken = 0;
    ProxyTelemetry proxy; ///< of that hand
    // While nobody tells what is felt, the plots go on without force.
    TracePoint last;
    bool pointDue = false;
    std::chrono::steady_clock::time_point polled = std::chrono::steady_clock::now();
    std::array<Wishes, std::size_t(kMaxHands)> wishes;
    Wish<double> pace;
};

} // namespace tactum
