// The whole program in a test: engine with a simulated hand, document and window, led by real events.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QPoint>
#include <QString>

#include "core/port/hand_target.h"
#include "core/runtime/local_engine.h"
#include "core/safety/force_gate.h"
#include "tests/support/waiting.h"
#include "tests/ui/cube_file.h"
#include "ui/document/document.h"
#include "ui/window/main_window.h"

class QAction;
class QDoubleSpinBox;

namespace tactum {

/// What a program must do once before its first window: surface format, C numbers, settings in `folder`.
void prepareProcess();
/// As somebody finds it who starts the program for the first time: the plots are folded.
void useSettingsIn(const QString& folder);
/// For a person who wants to see the plots; before the window is made.
void unfoldPlots();

/// A command of the menus by its id.
QAction& commandOf(const MainWindow& window, const char* id);

/// For the macros of Qt Test, which wait with the patience of tests/support/patience.h whatever it says here.
inline constexpr int kPatience = 60000; // ms

/// Beside a person who holds on to the keyboard: when another program takes it, or nobody has it since a
/// dialog went (there is no window manager), the window has it again before the test does anything else.
class TouchedWindow {
public:
    /// Makes another device around the simulated hand, one that gives trouble for instance.
    using Around = std::function<std::unique_ptr<HapticDevice>(std::unique_ptr<HapticDevice>)>;

    /// `size`: an invalid one leaves the window as it comes.
    explicit TouchedWindow(QSize size = {1200, 800}, const QStringList& samples = {},
                           const Around& around = {});
    ~TouchedWindow();

    /// Opens a file and waits until it can be felt.
    bool open(const QString& file);
    /// True once the loops use the newest World that was published.
    bool caughtUp();

    // Real mouse events at the window, positions in the view.
    QPoint centre() const;
    /// Where something is in the window.
    QRect placeOf(const QWidget& widget) const;
    void press(QPoint at);
    void moveTo(QPoint at);
    void release(QPoint at);
    /// Turns the wheel at a place of the view, away from the person: zooms in there, or pushes the held
    /// finger deeper.
    void wheel(QPoint at, int notches);
    /// Presses into the middle of the view, strokes to the right and lets go.
    void stroke();
    /// Lets the loops and the window run for so many frames.
    void frames(int count);
    /// Waits until the finger stands still: the hand has come to where the person wants it.
    bool atRest();

    /// Types a value into the inspector, as a person does: click, digits, Enter.
    void type(const QString& key, const QString& value);
    QDoubleSpinBox& box(const QString& key);
    /// By the keyboard: the command's key, or its name in the palette and Enter.
    void perform(const char* id);
    /// A command of the menus by its id.
    QAction& command(const char* id);
    /// Waits for the full strength of the force; a machine that is late takes it away: then a person arms
    /// anew.
    bool fullForce();

    const HapticOutput& touch() { return engine.proxy().output; }
    const Vec3& finger() { return engine.servo().finger; }

    std::shared_ptr<HandTarget> hand;
    LocalEngine engine;
    Document document;
    std::unique_ptr<MainWindow> window;

private:
    class Keyboard;

    std::unique_ptr<Keyboard> keyboard_;
};

} // namespace tactum
