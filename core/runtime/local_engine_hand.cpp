// What an engine says of each of its hands, and as an Engine of the one it speaks of.
#include <algorithm>

#include "core/base/realtime.h"
#include "core/runtime/local_engine_impl.h"

namespace tactum {

const DeviceInfo& LocalEngine::Hand::device() const {
    return engine_.sides[index_]->info;
}

std::string LocalEngine::Hand::trouble() const {
    return engine_.sides[index_]->device->trouble();
}

std::string LocalEngine::Hand::caution() const {
    return engine_.sides[index_]->device->caution();
}

Result<void> LocalEngine::Hand::setWorkspace(const Workspace& workspace) {
    assertNotRealtime();
    if (Result<void> possible = checkWorkspace(workspace); !possible) return possible;
    engine_.sides[index_]->workspace = workspace;
    engine_.channels->hand(index_).workspace.write(workspace);
    return {};
}

const Workspace& LocalEngine::Hand::workspace() const {
    return engine_.sides[index_]->workspace;
}

void LocalEngine::Hand::fade() {
    HandChannels& hand = engine_.channels->hand(index_);
    hand.fading.store(true, std::memory_order_relaxed);
    hand.armed.store(false, std::memory_order_release);
}

void LocalEngine::Hand::setArmed(bool armed) {
    HandChannels& hand = engine_.channels->hand(index_);
    hand.fading.store(false, std::memory_order_relaxed);
    hand.armed.store(armed, std::memory_order_relaxed);
}

bool LocalEngine::Hand::armed() const {
    return engine_.channels->hand(index_).armed.load(std::memory_order_relaxed);
}

void LocalEngine::Hand::setDeadMan(bool on) {
    engine_.sides[index_]->deadMan = on;
    engine_.askForButton(index_);
}

bool LocalEngine::Hand::deadMan() const {
    return engine_.channels->hand(index_).deadMan.load(std::memory_order_relaxed) != 0;
}

void LocalEngine::Hand::setOverrideCeiling(bool on) {
    engine_.channels->hand(index_).overrideCeiling.store(on, std::memory_order_relaxed);
}

bool LocalEngine::Hand::overridesCeiling() const {
    return engine_.channels->hand(index_).overrideCeiling.load(std::memory_order_relaxed);
}

void LocalEngine::Hand::push(const Vec3& force) {
    engine_.channels->hand(index_).outside.write({force, monotonicNanoseconds()});
}

void LocalEngine::Hand::setGrasped(bool on) {
    engine_.sides[index_]->grasped = on;
    engine_.channels->hand(index_).grasped.store(on, std::memory_order_relaxed);
}

/// A full queue holds the same order already.
void LocalEngine::Hand::restartProxy() {
    engine_.channels->commands.push({EngineCommand::Kind::RestartProxy, index_});
}

const TouchTelemetry& LocalEngine::Hand::touch() const {
    return engine_.sides[index_]->touch;
}

const ServoTelemetry& LocalEngine::Hand::servo() const {
    return engine_.sides[index_]->servo;
}

bool LocalEngine::Hand::servoStandsStill() const {
    return engine_.running && engine_.sides[index_]->beats.still;
}

bool LocalEngine::Hand::popTrace(TracePoint& point) {
    return engine_.channels->hand(index_).trace.pop(point);
}

// And of the one that the engine speaks of.

void LocalEngine::speakOf(std::size_t hand) {
    impl_->spoken = hand;
    impl_->tellSpoken();
    for (TracePoint before; popTrace(before);)
        continue;
}

std::size_t LocalEngine::spokenOf() const {
    return impl_->spoken;
}

const DeviceInfo& LocalEngine::device() const {
    return Hand(*impl_, impl_->spoken).device();
}
std::string LocalEngine::trouble() const {
    return Hand(*impl_, impl_->spoken).trouble();
}
std::string LocalEngine::caution() const {
    return Hand(*impl_, impl_->spoken).caution();
}
Result<void> LocalEngine::setWorkspace(const Workspace& workspace) {
    return Hand(*impl_, impl_->spoken).setWorkspace(workspace);
}
const Workspace& LocalEngine::workspace() const {
    return Hand(*impl_, impl_->spoken).workspace();
}
void LocalEngine::fade() {
    Hand(*impl_, impl_->spoken).fade();
}
void LocalEngine::setArmed(bool armed) {
    Hand(*impl_, impl_->spoken).setArmed(armed);
}
bool LocalEngine::armed() const {
    return Hand(*impl_, impl_->spoken).armed();
}
void LocalEngine::setDeadMan(bool on) {
    Hand(*impl_, impl_->spoken).setDeadMan(on);
}
bool LocalEngine::deadMan() const {
    return Hand(*impl_, impl_->spoken).deadMan();
}
void LocalEngine::setOverrideCeiling(bool on) {
    Hand(*impl_, impl_->spoken).setOverrideCeiling(on);
}
bool LocalEngine::overridesCeiling() const {
    return Hand(*impl_, impl_->spoken).overridesCeiling();
}
void LocalEngine::push(const Vec3& force) {
    Hand(*impl_, impl_->spoken).push(force);
}
void LocalEngine::setGrasped(bool on) {
    Hand(*impl_, impl_->spoken).setGrasped(on);
}
void LocalEngine::restartProxy() {
    Hand(*impl_, impl_->spoken).restartProxy();
}
const ServoTelemetry& LocalEngine::servo() const {
    return Hand(*impl_, impl_->spoken).servo();
}
bool LocalEngine::servoStandsStill() const {
    return Hand(*impl_, impl_->spoken).servoStandsStill();
}
bool LocalEngine::popTrace(TracePoint& point) {
    return Hand(*impl_, impl_->spoken).popTrace(point);
}

} // namespace tactum
