#include "core/runtime/hands.h"

#include <cassert>

#include "core/runtime/hands_elsewhere.h"
#include "core/runtime/local_engine.h"

namespace tactum {

Hands::Hands(Engine& engine)
    : engine_(engine), local_(dynamic_cast<LocalEngine*>(&engine)),
      elsewhere_(dynamic_cast<HandsElsewhere*>(&engine)) {
    assert(local_ || elsewhere_);
}

std::size_t Hands::count() const {
    return local_ ? local_->hands() : elsewhere_->hands();
}

bool Hands::mayAdd() const {
    return local_ && count() < std::size_t(kMaxHands);
}

std::size_t Hands::chosen() const {
    return local_ ? local_->spokenOf() : elsewhere_->spokenOf();
}

void Hands::choose(std::size_t hand) {
    local_ ? local_->speakOf(hand) : elsewhere_->speakOf(hand);
}

Result<void> Hands::add(std::unique_ptr<HapticDevice> device) {
    if (!local_)
        return inputError(
            "The engine: its loops are at a server; add the device there, with tactum serve --device.");
    return local_->addDevice(std::move(device));
}

Result<void> Hands::exchange(std::size_t hand, std::unique_ptr<HapticDevice> device) {
    return local_ ? local_->exchangeDevice(hand, std::move(device)) : engine_.setDevice(std::move(device));
}

Result<void> Hands::remove(std::size_t hand) {
    if (!local_)
        return inputError("The engine: its loops are at a server; its device cannot be removed here.");
    return local_->removeDevice(hand);
}

const TouchTelemetry& Hands::touch(std::size_t hand) const {
    return local_ ? local_->hand(hand).touch() : elsewhere_->told(hand).touch;
}

const DeviceInfo& Hands::device(std::size_t hand) const {
    return local_ ? local_->hand(hand).device() : elsewhere_->told(hand).device;
}

/// Of a server that is gone nothing is known but that.
std::string Hands::trouble(std::size_t hand) const {
    if (local_) return local_->hand(hand).trouble();
    return engine_.running() ? elsewhere_->told(hand).trouble : engine_.trouble();
}

const ServoTelemetry& Hands::servo(std::size_t hand) const {
    return local_ ? local_->hand(hand).servo() : elsewhere_->told(hand).servo;
}

bool Hands::servoStandsStill(std::size_t hand) const {
    return local_ ? local_->hand(hand).servoStandsStill() : elsewhere_->told(hand).standsStill;
}

Result<void> Hands::setWorkspace(std::size_t hand, const Workspace& workspace) {
    return local_ ? local_->hand(hand).setWorkspace(workspace) : elsewhere_->setWorkspaceOf(hand, workspace);
}

void Hands::setGrasped(std::size_t hand, bool on) {
    local_ ? local_->hand(hand).setGrasped(on) : elsewhere_->setGraspedOf(hand, on);
}

void Hands::restartProxy(std::size_t hand) {
    local_ ? local_->hand(hand).restartProxy() : elsewhere_->restartProxyOf(hand);
}

void Hands::setArmed(std::size_t hand, bool armed) {
    local_ ? local_->hand(hand).setArmed(armed) : elsewhere_->setArmedOf(hand, armed);
}

bool Hands::armed(std::size_t hand) const {
    return local_ ? local_->hand(hand).armed() : elsewhere_->told(hand).armed;
}

void Hands::setAllArmed(bool armed) {
    local_ ? local_->setAllArmed(armed) : elsewhere_->setAllArmed(armed);
}

bool Hands::anyArmed() const {
    for (std::size_t hand = 0; hand < count(); ++hand)
        if (armed(hand)) return true;
    return false;
}

/// At a server an order that names no hand is for all of them.
void Hands::setDeadMan(bool on) {
    if (!local_) return engine_.setDeadMan(on);
    for (std::size_t hand = 0; hand < count(); ++hand)
        local_->hand(hand).setDeadMan(on);
}

} // namespace tactum
