// What the guard did, in words: one table for the window and for recordings.
#pragma once

#include <array>
#include <cstddef>

#include "core/safety/inhibit_reason.h"

namespace tactum {

/// One sentence each for what happened, what was done about it and how to go on; `brief` is for lists.
struct InhibitWords {
    InhibitReason why;
    const char* brief;
    const char* what;
    const char* done;
    const char* remedy;
};

/// In the order of InhibitReason.
inline constexpr std::array<InhibitWords, 14> kInhibitWords{{
    {InhibitReason::Nothing, "full force", "The device gets its full force.", "", ""},
    {InhibitReason::NotArmed, "forces off", "The forces are off.", "The device gets no force.",
     "Switch them on when you hold the handle."},
    {InhibitReason::DeadMan, "the button was let go", "The button that must be held is not.",
     "The device gets no force.", "Hold the button to feel; if you do, let it go once first."},
    {InhibitReason::Stall, "the servo or the device stood still",
     "The servo or the device stood still for more than 10 ms.", "The force was taken away.",
     "It comes back softly by itself."},
    {InhibitReason::ProxySilent, "the proxy loop did not answer", "The proxy loop did not answer for 0.1 s.",
     "The force was taken away.", "It comes back softly when the loop answers; a lighter scene helps."},
    {InhibitReason::Settling, "the force waits until it is small", "The force is about to begin.",
     "It waits until it would be small for 20 ms.", "Move the finger slowly for a moment."},
    {InhibitReason::Rising, "the force comes back", "The force comes back.",
     "It rises to all of it in 0.6 s, slower under load.", "Hold the handle."},
    {InhibitReason::DeviceLost, "the device was lost",
     "The device sent nothing, or readings that cannot be true.", "The force was taken away.",
     "Look at its cable and its power, then arm again."},
    {InhibitReason::TooFast, "the finger was too fast", "The finger was faster than a hand that holds it.",
     "The force was taken away.", "Take the handle firmly, then arm again."},
    {InhibitReason::ForceJump, "the force jumped",
     "The force would have jumped by more than a surface can push.", "It was taken away instead.",
     "Draw the finger out of the surface, then arm again."},
    {InhibitReason::NotFinite, "the force was no number", "The scene asked for a force that is no number.",
     "The force was taken away.", "Undo the last edit, then arm again."},
    {InhibitReason::Unguarded, "the device watchdog died",
     "The process that stops the device in an emergency does not answer.", "The force was taken away.",
     "Save your work and start the program again."},
    {InhibitReason::Clutched, "the clutch is held", "The clutch is held: the handle moves, the finger stays.",
     "The device gets no force.", "Let the button go to feel again."},
    {InhibitReason::Stopped, "the device's stop button", "A button of the device has ended all force.",
     "The device gets no force.", "Switch the forces on again when you hold the handle."},
}};

/// Thread: any.
constexpr const InhibitWords& inhibitWords(InhibitReason why) noexcept {
    return kInhibitWords[std::size_t(why)];
}

} // namespace tactum
