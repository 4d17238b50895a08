#include "tests/device/falcon/emulated_falcon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/device/usb/emulated_kernel.h"

namespace tactum::test {
namespace {

using kernel::Inside;

constexpr double kBootBaud = 9600, kLoadBaud = 3e6 / 21, kRunBaud = 1.5e6;
const Vec3 kOrigin(0, 0, 0.125); ///< of the driver's frame D, from the middle of the base
/// Of the index marks of the legs, and of count 0 once they were passed.
const Vec3 kIndexDegrees(41, 36, 38);
constexpr double kZeroDegrees = 35, kDegreesPerCount = 14.25 / 110 * 360 / 1280;
constexpr double kWork = 30e-6; ///< s that the firmware takes for an answer
constexpr std::size_t kFaultyByte = 500;

bool isAt(double baud, const EmulatedFt232::LineByte& byte) {
    return byte.baud > 0.97 * baud && byte.baud < 1.03 * baud;
}

std::uint64_t packed(const FalconLegs& legs) {
    return std::uint64_t(std::uint16_t(legs[0])) | std::uint64_t(std::uint16_t(legs[1])) << 16 |
           std::uint64_t(std::uint16_t(legs[2])) << 32;
}
FalconLegs unpacked(std::uint64_t bits) {
    return {std::int16_t(bits), std::int16_t(bits >> 16), std::int16_t(bits >> 32)};
}

int numberAt(const Bytes& text, std::size_t at) {
    int value = 0;
    for (int digit = 3; digit >= 0; --digit)
        value = 16 * value + (text[at + std::size_t(digit)] - 'A');
    return value >= 32768 ? value - 65536 : value;
}

void putNumber(Bytes& text, int value) {
    unsigned rest = value < 0 ? unsigned(value + 65536) : unsigned(value);
    for (int digit = 0; digit < 4; ++digit, rest /= 16)
        text.push_back(std::uint8_t('A' + rest % 16));
}

} // namespace

EmulatedFalcon::EmulatedFalcon(double hurry) : hurry_(hurry), chip_(hurry) {
    times_.reserve(120'000);
}

// ---- The test's side.

void EmulatedFalcon::setFaults(const FalconFaults& faults) {
    const Inside inside;
    faults_ = faults;
    chip_.split = faults.split;
    chip_.babble = faults.babble;
    for (std::size_t leg = 0; leg < 3; ++leg)
        jump_[leg] = std::int16_t(jump_[leg] + faults.encoderJump[leg]);
    if (faults.frozenEncoders && !isFrozen_) frozen_ = counts();
    isFrozen_ = faults.frozenEncoders;
    if (faults.forgetsHome) homed_ = 0;
}

void EmulatedFalcon::setPower(bool on) {
    const Inside inside;
    reset();
    state_ = on ? State::Boot : State::Off;
}

void EmulatedFalcon::plug(int socket, const std::shared_ptr<EmulatedFalcon>& device) {
    EmulatedBus::the().unplug(socket);
    {
        const Inside inside;
        device->chip_ = EmulatedFt232(device->hurry_);
        device->first_ = true;
        device->firstHadTorque_ = false;
    }
    EmulatedBus::the().plug(socket, device);
}

void EmulatedFalcon::startFirmware(bool homed) {
    const Inside inside;
    reset();
    start();
    if (homed) homed_ = FalconReport::kAllHomed;
}

void EmulatedFalcon::setButtons(std::uint8_t buttons) {
    const Inside inside;
    buttons_ = buttons;
}
void EmulatedFalcon::setHand(const FalconBody::Hand& hand) {
    const Inside inside;
    body_.hand = hand;
}
void EmulatedFalcon::homeByHand() {
    const Inside inside;
    body_.home();
}
void EmulatedFalcon::putGrip(const Vec3& p_D) {
    const Inside inside;
    body_.put(p_D + kOrigin);
}
void EmulatedFalcon::leadGrip(const Vec3& p_D) {
    const Inside inside;
    body_.leadTo(p_D + kOrigin);
}
bool EmulatedFalcon::gripArrived() const {
    const Inside inside;
    return body_.arrived();
}
EmulatedFalcon::State EmulatedFalcon::state() const {
    const Inside inside;
    return state_;
}
bool EmulatedFalcon::homed() const {
    const Inside inside;
    return homed_ == FalconReport::kAllHomed;
}
Vec3 EmulatedFalcon::grip() const {
    const Inside inside;
    return body_.position() - kOrigin;
}
Vec3 EmulatedFalcon::force() const {
    const Inside inside;
    return forceAtGrip(body_.position(), torques());
}
FalconLegs EmulatedFalcon::motors() const {
    return unpacked(*motors_);
}
FalconLight EmulatedFalcon::light() const {
    const Inside inside;
    return light_;
}
int EmulatedFalcon::latency() const {
    const Inside inside;
    return chip_.latency;
}
int EmulatedFalcon::uploads() const {
    const Inside inside;
    return uploads_;
}
int EmulatedFalcon::commands() const {
    const Inside inside;
    return commands_;
}
int EmulatedFalcon::malformed() const {
    const Inside inside;
    return malformed_;
}
int EmulatedFalcon::torqueCommands() const {
    const Inside inside;
    return torqueCommands_;
}
bool EmulatedFalcon::overdriven() const {
    const Inside inside;
    return overdriven_;
}
bool EmulatedFalcon::firstHadTorque() const {
    const Inside inside;
    return firstHadTorque_;
}
std::vector<std::int64_t> EmulatedFalcon::commandTimes() const {
    const Inside inside;
    return times_;
}

// ---- The bus's side.

UsbDescription EmulatedFalcon::describe() const {
    return {0x0403, 0xcb48, 0x0600, "FTDI", "FALCON HAPTIC"};
}

std::optional<Bytes> EmulatedFalcon::control(const UsbSetup& setup, std::span<const std::uint8_t>,
                                             std::int64_t now) {
    advance(now);
    const auto answer = chip_.control(setup);
    if (chip_.takeReset() && state_ != State::Off) reset();
    return answer;
}

void EmulatedFalcon::out(std::span<const std::uint8_t> bytes, std::int64_t now) {
    advance(now);
    chip_.fromHost(bytes, now);
    advance(now);
}

std::optional<Bytes> EmulatedFalcon::in(std::int64_t now) {
    advance(now);
    return chip_.toHost(now);
}

std::int64_t EmulatedFalcon::nextIn(std::int64_t now) const {
    return chip_.nextToHost(now);
}

// ---- Time.

void EmulatedFalcon::advance(std::int64_t now) {
    while (const auto byte = chip_.fromLine(now)) {
        moveTo(byte->at);
        hear(*byte);
    }
    moveTo(now);
}

void EmulatedFalcon::moveTo(std::int64_t now) {
    constexpr std::int64_t kStep = 200'000, kMax = 300'000'000;
    if (time_ == 0 || now - time_ > kMax) time_ = std::max(time_, now - (time_ ? kMax : 0));
    while (time_ < now) {
        const std::int64_t step = std::min(kStep, now - time_);
        const Vec3 before = body_.degrees();
        body_.step(1e-9 * double(step), torques());
        watchIndexMarks(before);
        time_ += step;
    }
}

void EmulatedFalcon::watchIndexMarks(const Vec3& before) {
    if (state_ != State::Running || !homing_) return;
    const Vec3 after = body_.degrees();
    for (int leg = 0; leg < 3; ++leg)
        if ((before[leg] - kIndexDegrees[leg]) * (after[leg] - kIndexDegrees[leg]) <= 0)
            homed_ |= std::uint8_t(1 << leg);
}

// ---- The processor.

void EmulatedFalcon::reset() {
    state_ = State::Boot;
    heard_.clear();
    called_ = false;
    homed_ = 0;
    homing_ = false;
    light_ = FalconLight::Off;
    jump_ = {};
    *motors_ = 0;
}

void EmulatedFalcon::start() {
    state_ = State::Running;
    heard_.clear();
    first_ = true;
    firstHadTorque_ = false;
}

void EmulatedFalcon::hear(const EmulatedFt232::LineByte& byte) {
    switch (state_) {
    case State::Off:
        return;
    case State::Boot:
        return hearBoot(byte);
    case State::Loading:
        return hearFirmwareByte(byte);
    case State::Running:
        return hearCommandByte(byte);
    }
}

void EmulatedFalcon::say(const Bytes& bytes, double baud, std::int64_t at) {
    for (const std::uint8_t byte : bytes)
        chip_.toLine(byte, baud, at);
}

/// "\nC\r" at the slow rate is answered; after that an 'A' at the fast one begins the loading.
void EmulatedFalcon::hearBoot(const EmulatedFt232::LineByte& byte) {
    if (called_ && byte.byte == 'A' && isAt(kLoadBaud, byte)) {
        state_ = State::Loading;
        heard_.clear();
        say({'A'}, kLoadBaud, byte.at);
        return;
    }
    if (!isAt(kBootBaud, byte)) return;
    heard_.push_back(byte.byte);
    if (heard_.size() > 3) heard_.erase(heard_.begin());
    if (heard_ != Bytes{'\n', 'C', '\r'}) return;
    heard_.clear();
    if (faults_.deafTries > 0) {
        --faults_.deafTries;
        return;
    }
    for (int i = 0; i < faults_.junkFirst; ++i)
        say({std::uint8_t(random_())}, kBootBaud, byte.at);
    if (faults_.zeroFirst) say({0}, kBootBaud, byte.at);
    say({'\n', 'D', ',', '\r'}, kBootBaud, byte.at);
    called_ = true;
}

/// Key, 8 words, entry point; then blocks until one has no length. Every byte is echoed.
void EmulatedFalcon::hearFirmwareByte(const EmulatedFt232::LineByte& byte) {
    if (!isAt(kLoadBaud, byte)) return;
    heard_.push_back(byte.byte);
    const bool faulty = heard_.size() == kFaultyByte;
    if (faulty && faults_.lostEchoes > 0)
        --faults_.lostEchoes;
    else if (faulty && faults_.corruptEchoes > 0) {
        --faults_.corruptEchoes;
        say({std::uint8_t(byte.byte ^ 0x10)}, kLoadBaud, byte.at);
    } else
        say({byte.byte}, kLoadBaud, byte.at);

    constexpr std::size_t kHead = 22;
    if (heard_.size() == kHead) blockLeft_ = 0;
    if (heard_.size() <= kHead) return;
    if (blockLeft_ > 0) {
        --blockLeft_;
        return;
    }
    if (heard_.size() % 2) return; // the length has two bytes
    const std::size_t words = heard_[heard_.size() - 2] + 256u * heard_[heard_.size() - 1];
    blockLeft_ = 2 * (words + 2);
    if (words > 0) return;
    ++uploads_;
    if (faults_.startsNoFirmware || heard_[0] != 0xaa || heard_[1] != 0x08)
        reset();
    else
        start();
}

void EmulatedFalcon::hearCommandByte(const EmulatedFt232::LineByte& byte) {
    if (!isAt(kRunBaud, byte)) return;
    if (heard_.empty() && byte.byte != '<') {
        ++malformed_;
        return;
    }
    heard_.push_back(byte.byte);
    if (heard_.size() < 16) return;
    if (heard_[15] == '>') {
        obey();
        report(byte.at + std::int64_t(1e9 * kWork / hurry_));
    } else
        malformed_ += 16;
    heard_.clear();
}

void EmulatedFalcon::obey() {
    FalconLegs motors;
    for (std::size_t leg = 0; leg < 3; ++leg)
        motors[leg] = std::int16_t(numberAt(heard_, 1 + 4 * leg));
    const unsigned flags = heard_[13] - 'A';
    homing_ = flags & 1;
    light_ = FalconLight(flags & 0xe);
    *motors_ = packed(motors);
    const bool torque = motors != FalconLegs{};
    overdriven_ = overdriven_ || std::ranges::any_of(motors, [](int m) { return std::abs(m) > 4095; });
    if (std::exchange(first_, false)) firstHadTorque_ = torque;
    torqueCommands_ += torque;
    ++commands_;
    if (times_.size() == times_.capacity()) times_.erase(times_.begin(), times_.begin() + 60'000);
    times_.push_back(time_);
}

void EmulatedFalcon::report(std::int64_t at) {
    if (faults_.silent) return;
    if (faults_.lostReports > 0) {
        --faults_.lostReports;
        return;
    }
    Bytes text{'<'};
    for (const int count : counts())
        putNumber(text, count);
    text.push_back(std::uint8_t('A' + buttons_ + 16 * homed_));
    text.push_back('A');
    text.push_back('>');
    if (faults_.wrongEnds > 0) {
        --faults_.wrongEnds;
        text.back() = 'x';
    }
    if (faults_.shortReports > 0) {
        --faults_.shortReports;
        text.erase(text.begin() + std::ptrdiff_t(random_() % text.size()));
    }
    for (int i = 0; i < faults_.junk; ++i)
        say({std::uint8_t(random_())}, kRunBaud, at);
    for (int i = 0; i <= faults_.repeats; ++i)
        say(text, kRunBaud, at);
}

FalconLegs EmulatedFalcon::counts() const {
    if (isFrozen_) return frozen_;
    FalconLegs counts;
    const Vec3 degrees = body_.degrees();
    for (int leg = 0; leg < 3; ++leg) {
        const double zero = homed_ & (1 << leg) ? kZeroDegrees : zero_[leg];
        counts[std::size_t(leg)] =
            std::int16_t(std::lround((degrees[leg] - zero) / kDegreesPerCount) + jump_[std::size_t(leg)]);
    }
    return counts;
}

/// A positive command makes the angle smaller.
Vec3 EmulatedFalcon::torques() const {
    const FalconLegs m = unpacked(*motors_);
    return Vec3(m[0], m[1], m[2]) / -kCountsPerTorque;
}

} // namespace tactum::test
