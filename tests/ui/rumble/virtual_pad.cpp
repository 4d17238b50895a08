#define SDL_MAIN_HANDLED
#include "tests/ui/rumble/virtual_pad.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include <SDL.h>

namespace tactum {

struct VirtualPad::Motors {
    mutable std::mutex mutex;
    std::vector<Told> told;
};

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "no virtual gamepad: %s: %s\n", what, SDL_GetError());
    std::abort();
}

} // namespace

VirtualPad::VirtualPad(const char* name, std::uint16_t kind, bool motors)
    : motors_(std::make_unique<Motors>()) {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_JOYSTICK) != 0) fail("SDL_InitSubSystem");
    SDL_VirtualJoystickDesc desc{};
    desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    desc.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
    desc.naxes = 6;
    desc.nbuttons = 15;
    desc.vendor_id = 0x7ac7;
    desc.product_id = kind;
    desc.name = name;
    desc.userdata = motors_.get();
    if (motors)
        desc.Rumble = [](void* of, Uint16 low, Uint16 high) {
            auto& noted = *static_cast<Motors*>(of);
            const std::lock_guard lock(noted.mutex);
            noted.told.push_back({now(), low / 65535.0, high / 65535.0});
            return 0;
        };
    SDL_LockJoysticks();
    const int index = SDL_JoystickAttachVirtualEx(&desc);
    if (index >= 0) instance_ = SDL_JoystickGetDeviceInstanceID(index);
    SDL_UnlockJoysticks();
    if (instance_ < 0) fail("SDL_JoystickAttachVirtualEx");
}

VirtualPad::~VirtualPad() {
    unplug();
    SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
}

void VirtualPad::unplug() {
    SDL_LockJoysticks();
    for (int index = 0; index < SDL_NumJoysticks(); ++index)
        if (SDL_JoystickGetDeviceInstanceID(index) == instance_) {
            SDL_JoystickDetachVirtual(index);
            break;
        }
    SDL_UnlockJoysticks();
}

std::vector<VirtualPad::Told> VirtualPad::told() const {
    const std::lock_guard lock(motors_->mutex);
    return motors_->told;
}

VirtualPad::Told VirtualPad::last() const {
    const auto all = told();
    return all.empty() ? Told{} : all.back();
}

} // namespace tactum
