#include "ui/base/preferences.h"

#include <cmath>

#include <QSettings>

#include "core/scene/placing.h"
#include "ui/base/style.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

/// A choice's parameter: its value is the place among `count` choices.
constexpr Parameter chosen(const char* key, const char* label, std::size_t count, const char* sentence,
                           double initial = 0) {
    return {key, label, "", 0, double(count - 1), 1, initial, 0, sentence};
}

constexpr auto kCamera = "Mouse and camera";
constexpr auto kNumbers = "Numbers";
constexpr auto kLook = "Look";
constexpr auto kSaving = "Saving";
constexpr auto kLimits = "Limits";
constexpr auto kGamepad = "Gamepad";

const std::vector<Preference>& table() {
    static const std::vector<Preference> kTable{
        {Preferred::DragTurns,
         kCamera,
         chosen("camera/buttons", "A drag with the mouse", 3,
                "Which button turns the camera and which moves it sideways. A drag with the left button "
                "beside the "
                "model turns it always."),
         {"Middle turns, Shift+middle moves", "Middle moves, Shift+middle turns",
          "Right turns, middle moves"}},
        {Preferred::TurnSpeed,
         kCamera,
         {"camera/turn-speed", "Turning", "x", 0.25, 4, 0.25, 1, 2,
          "How far a drag turns the camera: 1 is half a turn for the shorter side of the view."},
         {}},
        {Preferred::ZoomSpeed,
         kCamera,
         {"camera/zoom-speed", "Zooming", "x", 0.25, 4, 0.25, 1, 2,
          "How much nearer a notch of the wheel comes: 1 is 13 %."},
         {}},
        {Preferred::WheelAway,
         kCamera,
         chosen("camera/wheel", "The wheel turned away", 2,
                "Where the camera goes when the wheel is turned away from you."),
         {"Comes nearer", "Goes farther"}},
        {Preferred::ZoomTo,
         kCamera,
         chosen("camera/zoom-to", "Zoom to", 2, "Which point keeps its place while the wheel zooms."),
         {"The cursor", "The middle of the view"}},
        {Preferred::Flight,
         kCamera,
         chosen("camera/flight", "The camera goes to a view", 2,
                "Whether the camera is seen on its way to a standard view or a problem."),
         {"In a moment, along its way", "At once"}},
        {Preferred::Lag,
         kCamera,
         chosen(
             "camera/lag", "Pseudo-haptic mouse", 2,
             "On: the finger lags behind the mouse against a force and hurries with one, and the pointer is "
             "hidden meanwhile. The eye feels friction and bumps without a device."),
         {"Off", "On"}},
        {Preferred::Lengths,
         kNumbers,
         chosen("units/length", "Lengths", std::size(kLengthUnits),
                "In which unit lengths are shown and typed. Plots, devices and files keep theirs; other "
                "units can "
                "always be typed with their names, as in \"0.2 in\".",
                2),
         {"Metres", "Centimetres", "Millimetres", "Inches"}}, // those of kLengthUnits
        {Preferred::Stiffnesses,
         kNumbers,
         chosen("units/stiffness", "Stiffness", 2, "In which unit stiffnesses are shown and typed."),
         {"N/m", "N/mm"}},
        {Preferred::Theme,
         kLook,
         chosen("theme", "Theme", 3, "Also under View > Look > Theme."),
         {"Dark", "Light", "Like the system"}},
        {Preferred::Size,
         kLook,
         {"look/size", "Size of everything", "%", 75, 300, 25, 100, 0,
          "Of text, icons and fields, as part of what the screen asks for."},
         {},
         true},
        {Preferred::Language,
         kLook,
         chosen("look/language", "Language", 3,
                "Of the window. Messages about files and devices, the guide and the command line are in "
                "English."),
         {"Like the system", "English", "Deutsch"},
         true},
        {Preferred::JournalTime,
         kSaving,
         {"journal/seconds", "Kept for a crash after", "s", 2, 600, 5, 25, 0,
          "An edit that is not saved is in the recovery journal after this time at the latest. The first "
          "edits are "
          "after two seconds."},
         {}},
        {Preferred::JournalEdits,
         kSaving,
         {"journal/edits", "or after so many edits", "", 1, 200, 1, 20, 0, "Whichever comes first."},
         {}},
        {Preferred::LargestForce,
         kLimits,
         {"limits/force", "Largest force", "N", 0, 50, 0.5, 0, 1,
          "No device gives more, whatever it can and whatever a scene asks for; 0 is as much as it can. "
          "Counts "
          "for a device from when it is connected, for the simulated hand from the next start on."},
         {}},
        {Preferred::Vibration,
         kGamepad,
         {"gamepad/strength", "Strength of the vibration", "x", 0.1, 20, 0.1, 1, 1,
          "At 1 a vibration of 1 N turns a motor with all it has, at 4 one of 0.25 N. Device > Gamepad "
          "switches it on."},
         {}},
    };
    return kTable;
}

QString keyOf(Preferred id) {
    return asIs(preference(id).parameter.key);
}

} // namespace

std::span<const Preference> preferenceTable() {
    return table();
}

const Preference& preference(Preferred id) {
    return table().at(std::size_t(id));
}

Preferences& Preferences::instance() {
    static Preferences one;
    return one;
}

double Preferences::value(Preferred id) const {
    const Parameter& of = preference(id).parameter;
    bool number = false;
    const double kept = QSettings().value(keyOf(id)).toDouble(&number);
    const double value = number ? of.clamped(kept) : of.initial;
    return of.decimals > 0 ? value : std::round(value);
}

void Preferences::set(Preferred id, double value) {
    const double before = this->value(id);
    QSettings().setValue(keyOf(id), preference(id).parameter.clamped(value));
    if (this->value(id) != before) emit changed(id);
}

} // namespace tactum
