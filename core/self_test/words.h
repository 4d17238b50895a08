// What a self-test says to the person and of the device: sentences with places for what changes.
#pragma once

#include <string>
#include <vector>

namespace tactum {

/// A sentence or a name whose places %1, %2 ... are filled with parts, each again such words: a number, an
/// axis, "to the right". So the window can say all of it in its own language.
struct TrialWords {
    TrialWords() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): plain words are words
    TrialWords(const char* theForm) : form(theForm) {}
    // NOLINTNEXTLINE(google-explicit-constructor): likewise
    TrialWords(std::string theForm) : form(std::move(theForm)) {}
    TrialWords(const char* theForm, std::vector<TrialWords> theParts)
        : form(theForm), parts(std::move(theParts)) {}

    /// As the terminal and the report have it.
    std::string english() const;
    bool empty() const { return form.empty(); }

    std::string form;
    std::vector<TrialWords> parts;
};

namespace trial_words {

// The parts of the test.
inline constexpr const char *kRest = "The device at rest", *kRuler = "Along a ruler",
                            *kMotors = "Which way the motors push", *kDynamics = "What the motors move",
                            *kWeight = "What a newton is", *kButtons = "The buttons";

// Ways of the handle.
inline constexpr const char *kToTheRight = "to the right", *kUpwards = "upwards", *kTowardYou = "toward you";

// What the person does.
inline constexpr const char* kLetRest = "Let go of the handle, so that it rests by itself.";
inline constexpr const char* kHoldZero = "Lay a ruler that points %1, and hold the handle at its beginning, "
                                         "near the middle of the workspace.";
inline constexpr const char* kLeadAlong = "Lead the handle 40 mm %1 along the ruler, and hold it there.";
inline constexpr const char* kLetTwitch =
    "Lead the handle to the middle of the workspace and let go. It will twitch a little each way.";
inline constexpr const char* kLetShake = "Keep your hands off: it holds itself in the middle and shakes.";
inline constexpr const char* kLetSwing = "Keep your hands off: it swings slowly, without the mass.";
inline constexpr const char* kHang = "Hang the mass on the handle by a thread, and let it come to rest.";
inline constexpr const char* kPress = "When you go on, press and release each button once within %1 seconds.";

// What it does by itself.
inline constexpr const char* kListening = "Listening to the device at rest.";
inline constexpr const char* kShaking = "Shaking along %1.";

// What is left out, and why.
inline constexpr const char* kRulerAlong = "the ruler along %1";
inline constexpr const char* kDirections = "the motors' directions, and what rests on them";
inline constexpr const char* kNoPlaces = "the motors' directions: the readings do not say where it goes";
inline constexpr const char* kFigures = "mass, damping, friction and delay";
inline constexpr const char* kFiguresNoSpring =
    "mass, damping, friction and delay: no spring can hold the handle";
inline constexpr const char* kFiguresHardly =
    "mass, damping, friction and delay along %1: it hardly moved, or something held it";
inline constexpr const char* kWeighing = "the weight of a known mass";
inline constexpr const char* kWeighingNoSpring = "the weight of a known mass: no spring can hold the handle";
inline constexpr const char* kWeighingMass = "the weight of a known mass, which must be from 5 to %1 g";
inline constexpr const char* kPressing = "the buttons";
inline constexpr const char* kAllAfter = "all that was to come after the end that you asked for";

// What is wrong, and what to do.
inline constexpr const char* kSlow = "It reads %1 times a second and not %2: plug it into a socket of the "
                                     "computer itself, and look at tactum devices --latency 10.";
inline constexpr const char* kStuck = "A button counts as held that nobody holds: look whether it is stuck.";
inline constexpr const char* kOtherWay =
    "%1 runs the other way: its reading falls when the handle moves %2. The driver has to be repaired.";
inline constexpr const char* kScale = "%1 reads %2 times as far as the ruler says.";
inline constexpr const char* kTwice = "Two ways of the handle are read along one axis: an encoder or its "
                                      "cable is broken, or the ruler lay askew.";
inline constexpr const char* kExchanged = "%1 and %2 are exchanged.";
inline constexpr const char* kReadAlong = "The way along %1 is read along %2.";
inline constexpr const char* kHardly = "The readings hardly change when the handle moves %1: an encoder or "
                                       "its cable is broken.";
inline constexpr const char* kNoPush = "The device does not push along %1: look at the supply of its motors, "
                                       "and whether something holds it.";
inline constexpr const char* kPushAlong = "The motors push along %1 when they should along %2.";
inline constexpr const char* kPushOtherWay = "The motors push the other way along %1.";
inline constexpr const char* kNoWeight =
    "The motors do not feel the known mass: it did not hang freely, or they are far too strong.";
inline constexpr const char* kNewton =
    "The motors push %1 times as hard as they are told, along y: calibrate the driver (docs/devices.md).";
inline constexpr const char* kLate = "Forces come %1 ticks after their reading, and the profile says %2: "
                                     "with it surfaces may be too stiff and tremble.";
inline constexpr const char* kDeaf = "Button %1 of %2 was not heard.";
inline constexpr const char* kHeldOn = "Button %1 was not heard to be released.";
inline constexpr const char* kMore = "It tells of more buttons than the %1 that its profile says.";

// Figures, and the unit that is a word.
inline constexpr const char* kReadings = "new readings";
inline constexpr const char* kMedian = "median time between two readings";
inline constexpr const char* kLongestGap = "longest time between two readings";
inline constexpr const char* kNoise = "noise of the position at rest";
inline constexpr const char* kScaleOf = "scale of the position along %1";
inline constexpr const char* kForceScale = "force along y to the force that is asked for";
inline constexpr const char* kResolution = "resolution of the position";
inline constexpr const char* kMass = "moving mass along %1";
inline constexpr const char* kDamping = "damping along %1";
inline constexpr const char* kFriction = "dry friction along %1";
inline constexpr const char* kDelay = "delay from command to force along %1";
inline constexpr const char* kUnexplained = "force that the model does not explain along %1";
inline constexpr const char* kLeastDamping = "least damping";
inline constexpr const char* kLeastFriction = "least dry friction";
inline constexpr const char* kLongestDelay = "longest delay, with the amplifier's lag";
inline constexpr const char* kLag = "amplifier's lag, as it stands in the delay";
inline constexpr const char* kTicks = "ticks";

/// All of them, for translations.
inline constexpr const char* kAll[] = {kRest,          kRuler,        kMotors,
                                       kDynamics,      kWeight,       kButtons,
                                       kToTheRight,    kUpwards,      kTowardYou,
                                       kLetRest,       kHoldZero,     kLeadAlong,
                                       kLetTwitch,     kLetShake,     kLetSwing,
                                       kHang,          kPress,        kListening,
                                       kShaking,       kRulerAlong,   kDirections,
                                       kNoPlaces,      kFigures,      kFiguresNoSpring,
                                       kFiguresHardly, kWeighing,     kWeighingNoSpring,
                                       kWeighingMass,  kPressing,     kAllAfter,
                                       kSlow,          kStuck,        kOtherWay,
                                       kScale,         kTwice,        kExchanged,
                                       kReadAlong,     kHardly,       kNoPush,
                                       kPushAlong,     kPushOtherWay, kNoWeight,
                                       kNewton,        kLate,         kDeaf,
                                       kHeldOn,        kMore,         kReadings,
                                       kMedian,        kLongestGap,   kNoise,
                                       kScaleOf,       kForceScale,   kResolution,
                                       kMass,          kDamping,      kFriction,
                                       kDelay,         kUnexplained,  kLeastDamping,
                                       kLeastFriction, kLongestDelay, kLag,
                                       kTicks};

} // namespace trial_words

} // namespace tactum
