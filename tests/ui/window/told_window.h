// The window around an engine that does nothing and tells what a test says of its hands: laid out as on a
// screen, and never drawn. What it makes of faults, hands, studies and recordings is seen without loops.
#pragma once

#include <memory>

#include "tests/ui/told_engine.h"
#include "tests/ui/window/window_effects.h"

namespace tactum {

struct ToldWindow {
    /// `tell`: what the engine says of its hands before there is a window.
    explicit ToldWindow(std::size_t hands = 1, const std::function<void(test::ToldEngine&)>& tell = {});
    ~ToldWindow();
    ToldWindow(const ToldWindow&) = delete;
    ToldWindow& operator=(const ToldWindow&) = delete;

    /// The engine feels what was published last.
    void catchUp();
    QAction& command(const char* id) const { return commandOf(*window, id); }
    /// So many frames go by.
    void frames(int count) const { QTest::qWait(count * 16); }
    /// What differs after each of its notes; `prepare` is done before each.
    WindowEffects effects(std::function<void()> prepare = [] {});

    test::ToldEngine engine;
    std::shared_ptr<HandTarget> hand = std::make_shared<HandTarget>();
    Document document;
    std::unique_ptr<MainWindow> window;
};

} // namespace tactum
