// A window without a screen at a server of Served, over a real socket.
#pragma once

#include <cmath>

#include "core/haptics/compile.h"
#include "core/protocol/remote_engine.h"
#include "tests/core/protocol/guest.h"
#include "tests/support/patience.h"

namespace tactum::test {

inline constexpr double kDepth = 1e-3;

/// Polls, and takes what arrives.
struct Window {
    explicit Window(const std::string& target, const std::string& name = "window",
                    std::shared_ptr<HandTarget> hand = nullptr)
        : engine({.target = target, .name = name}, std::move(hand)) {}

    RemoteEngine engine;
    Scene scene;
    std::shared_ptr<const World> world;
    std::string refused;
    SharedScene::Arrival why = SharedScene::Arrival::Begun;

    /// Once a frame.
    void frame() {
        engine.poll();
        if (auto theirs = engine.arrived()) why = theirs->why, publish(theirs->scene);
        if (auto sentence = engine.refused()) refused = *sentence;
    }
    void publish(const Scene& next) {
        auto compiled = compile(next, world.get());
        if (!compiled) return;
        scene = next;
        world = std::move(*compiled);
        engine.publish(world);
    }
    void setStiffness(double stiffness) {
        Scene next = scene;
        next.objects.at(0).surfaces.at(0).material.stiffness = stiffness;
        publish(next);
    }
    template <class Holds> bool sees(Holds holds) {
        return eventually([&] {
            frame();
            return holds();
        });
    }
    bool felt() {
        return sees([&] { return world && engine.proxy().worldRevision == world->revision; });
    }
    bool press(Served& served) {
        engine.setArmed(true);
        if (!sees([&] { return engine.servo().gain == 1; })) return false;
        served.setHeight(kProxyRadius.initial - kDepth);
        return sees([&] { return std::abs(served.push() - kStiffness.initial * kDepth) < 1e-3; });
    }
};

} // namespace tactum::test
