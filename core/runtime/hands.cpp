#include "core/runtime/hands.h"

#include "core/runtime/local_engine.h"

namespace tactum {

Hands::Hands(Engine& engine) : engine_(engine), local_(dynamic_cast<LocalEngine*>(&engine)) {}

std::size_t Hands::count() const {
    return local_ ? local_->hands() : 1;
}

bool Hands::mayAdd() const {
    return local_ && count() < std::size_t(kMaxHands);
}

std::size_t Hands::chosen() const {
    return local_ ? local_->spokenOf() : 0;
}

void Hands::choose(std::size_t hand) {
    if (local_) local_->speakOf(hand);
}

Result<void> Hands::add(std::unique_ptr<HapticDevice> device) {
    if (!local_)
        return inputError("The engine: its loops are at a server, which has one hand; add the device there.");
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
    return local_ ? local_->hand(hand).touch() : engine_.proxy();
}

const DeviceInfo& Hands::device(std::size_t hand) const {
    return local_ ? local_->hand(hand).device() : engine_.device();
}

std::string Hands::trouble(std::size_t hand) const {
    return local_ ? local_->hand(hand).trouble() : engine_.trouble();
}

const ServoTelemetry& Hands::servo(std::size_t hand) const {
    return local_ ? local_->hand(hand).servo() : engine_.servo();
}

bool Hands::servoStandsStill(std::size_t hand) const {
    return local_ ? local_->hand(hand).servoStandsStill() : engine_.servoStandsStill();
}

Result<void> Hands::setWorkspace(std::size_t hand, const Workspace& workspace) {
    return local_ ? local_->hand(hand).setWorkspace(workspace) : engine_.setWorkspace(workspace);
}

void Hands::setGrasped(std::size_t hand, bool on) {
    local_ ? local_->hand(hand).setGrasped(on) : engine_.setGrasped(on);
}

void Hands::restartProxy(std::size_t hand) {
    local_ ? local_->hand(hand).restartProxy() : engine_.restartProxy();
}

void Hands::setArmed(std::size_t hand, bool armed) {
    local_ ? local_->hand(hand).setArmed(armed) : engine_.setArmed(armed);
}

bool Hands::armed(std::size_t hand) const {
    return local_ ? local_->hand(hand).armed() : engine_.armed();
}

void Hands::setAllArmed(bool armed) {
    for (std::size_t hand = 0; hand < count(); ++hand)
        setArmed(hand, armed);
}

bool Hands::anyArmed() const {
    for (std::size_t hand = 0; hand < count(); ++hand)
        if (armed(hand)) return true;
    return false;
}

void Hands::setDeadMan(bool on) {
    if (!local_) return engine_.setDeadMan(on);
    for (std::size_t hand = 0; hand < count(); ++hand)
        local_->hand(hand).setDeadMan(on);
}

} // namespace tactum
