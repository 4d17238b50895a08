#define SDL_MAIN_HANDLED
#include "ui/rumble/pads.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <SDL.h>

#include "core/base/realtime.h"

namespace tactum {

namespace {

constexpr auto kPace = std::chrono::milliseconds(8); ///< a pad on Bluetooth hears no more often

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

std::uint32_t word(double strength) {
    return std::uint32_t(std::lround(std::clamp(strength, 0.0, 1.0) * 0xFFFF));
}

/// The window's keys and signals are none of SDL's business, and it need not have the keyboard. Over
/// Bluetooth the pads of the PlayStation vibrate in their long reports alone.
void sayHints() {
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI_PS4_RUMBLE, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI_PS5_RUMBLE, "1");
}

std::string keyOf(SDL_Joystick* pad) {
    char guid[33] = {};
    SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(pad), guid, sizeof(guid));
    const char* serial = SDL_JoystickGetSerial(pad);
    return serial && *serial ? std::string(guid) + ':' + serial : std::string(guid);
}

} // namespace

struct Pads::Opened {
    Pad pad;
    int instance;
    SDL_Joystick* joystick;
};

Pads::Pads(std::function<void(std::vector<Pad>)> told) : told_(std::move(told)), thread_([this] { run(); }) {}

Pads::~Pads() {
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    ends_.notify_one();
    thread_.join();
}

void Pads::use(const std::string& key) {
    const std::lock_guard lock(mutex_);
    key_ = key;
}

void Pads::play(const MotorStrengths& strengths) {
    assertNotRealtime();
    strengths_ = word(strengths.low) << 16 | word(strengths.high);
    until_ = now() + kLasts * std::int64_t(1'000'000);
}

// SDL reads pads and hears of new ones while its events are asked for.
void Pads::run() {
    sayHints();
    const bool begun = SDL_InitSubSystem(SDL_INIT_JOYSTICK) == 0;
    for (int index = 0; begun && index < SDL_NumJoysticks(); ++index)
        add(index);
    tell();
    std::unique_lock lock(mutex_);
    while (!ends_.wait_for(lock, kPace, [this] { return end_; })) {
        lock.unlock();
        if (begun) look();
        drive();
        lock.lock();
    }
    for (const Opened& each : opened_) {
        SDL_JoystickRumble(each.joystick, 0, 0, 0);
        SDL_JoystickClose(each.joystick);
    }
    opened_.clear();
    if (begun) SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
    SDL_TLSCleanup(); // of a thread that SDL has not made
}

void Pads::look() {
    const auto keys = [this] {
        std::vector<Pad> pads;
        for (const Opened& each : opened_)
            pads.push_back(each.pad);
        return pads;
    };
    const std::vector<Pad> before = keys();
    for (SDL_Event event; SDL_PollEvent(&event);) {
        if (event.type == SDL_JOYDEVICEADDED) add(event.jdevice.which);
        if (event.type == SDL_JOYDEVICEREMOVED) remove(event.jdevice.which);
    }
    if (keys() != before) tell();
}

// Whether it vibrates is known of one that is open.
void Pads::add(int index) {
    const int instance = SDL_JoystickGetDeviceInstanceID(index);
    if (instance < 0 || std::ranges::find(opened_, instance, &Opened::instance) != opened_.end()) return;
    SDL_Joystick* joystick = SDL_JoystickOpen(index);
    if (!joystick) return;
    if (!SDL_JoystickHasRumble(joystick)) return SDL_JoystickClose(joystick);
    const char* name = SDL_JoystickName(joystick);
    const std::string kind = keyOf(joystick);
    std::string key = kind;
    const auto taken = [&] {
        return std::ranges::any_of(opened_, [&](const Opened& each) { return each.pad.key == key; });
    };
    for (int number = 2; taken(); ++number)
        key = kind + '/' + std::to_string(number);
    opened_.push_back({{key, name ? name : "Gamepad"}, instance, joystick});
}

void Pads::remove(int instance) {
    const auto gone = std::ranges::find(opened_, instance, &Opened::instance);
    if (gone == opened_.end()) return;
    SDL_JoystickClose(gone->joystick);
    opened_.erase(gone);
}

void Pads::tell() {
    std::vector<Pad> pads;
    for (const Opened& each : opened_)
        pads.push_back(each.pad);
    told_(std::move(pads));
}

Pads::Opened* Pads::used() {
    if (opened_.empty()) return nullptr;
    const std::lock_guard lock(mutex_);
    for (Opened& each : opened_)
        if (each.pad.key == key_) return &each;
    return &opened_.front();
}

// What is the same as before SDL does not send again; it would stop by itself as well.
void Pads::drive() {
    Opened* const one = used();
    for (const Opened& each : opened_)
        if (each.instance == driven_ && (!one || one->instance != driven_))
            SDL_JoystickRumble(each.joystick, 0, 0, 0);
    driven_ = one ? one->instance : -1;
    if (!one) return;
    const std::uint32_t strengths = now() < until_ ? strengths_.load() : 0;
    SDL_JoystickRumble(one->joystick, Uint16(strengths >> 16), Uint16(strengths & 0xFFFF), kLasts);
}

} // namespace tactum
