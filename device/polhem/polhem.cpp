#include "device/polhem/polhem.h"

#include <chrono>
#include <cstdlib>
#include <glob.h>
#include <thread>

#include <unistd.h>

#include "core/base/realtime.h"
#include "core/base/text.h"

namespace tactum {
namespace {

constexpr std::string_view kPrefix = "polhem:";
constexpr const char* kTeensys = "/dev/serial/by-id/*Teensyduino_USB_Serial*";
constexpr int kModel = 1; ///< of the boards that count

constexpr int kPatience = 2000; ///< ms, for a board to answer
constexpr int kAskEvery = 100;  ///< ms, as the maker's programs do
constexpr int kAskAgain = 5;    ///< ticks; an answer was lost
constexpr int kSilentTicks = 50;

std::vector<std::filesystem::path> boards() {
    const char* const named = std::getenv("TACTUM_POLHEM");
    glob_t found{};
    std::vector<std::filesystem::path> files;
    if (glob(named && *named ? named : kTeensys, 0, nullptr, &found) == 0)
        files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
    return files;
}

std::string idOf(const std::filesystem::path& file) {
    return std::string(kPrefix) + file.filename().string();
}

/// Until it says so, or its patience is over: every millisecond.
template <class Condition> bool wait(Condition isSo) {
    for (int passed = 0; passed < kPatience; ++passed) {
        if (isSo(passed)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

} // namespace

std::vector<DeviceListing> listPolhem() {
    std::vector<DeviceListing> listings;
    for (const auto& file : boards()) {
        DeviceListing listing{idOf(file), "Haptikfabriken Polhem", true,
                              "a Teensy board is at " + printable(file.string(), kLongestName) +
                                  ", as a Polhem has one; its arm has to be in its rest when it gets power"};
        if (access(file.c_str(), R_OK | W_OK) != 0) {
            listing.usable = false;
            listing.forbidden = true;
            listing.sentence = "connected at " + printable(file.string(), kLongestName) +
                               ", but you have no permission to use it: install the rule "
                               "resources/udev/70-tactum.rules in /etc/udev/rules.d and plug it in again";
        }
        listings.push_back(std::move(listing));
    }
    return listings;
}

Result<std::unique_ptr<HapticDevice>> makePolhem(const std::string& id, const DeviceInfo& profile) {
    for (const auto& file : boards())
        if (idOf(file) == id) return std::make_unique<Polhem>(file, profile);
    return machineError("The Polhem of \"" + id +
                        "\" is not connected: plug it in, or choose another device.");
}

Polhem::Polhem(std::filesystem::path file, DeviceInfo profile)
    : file_(std::move(file)), profile_(std::move(profile)), limit_{.maxForce = profile_.maxForce} {}

Polhem::~Polhem() {
    close();
}

// ---- Making it ready

Result<void> Polhem::open() {
    assertNotRealtime();
    if (way_) return {};
    auto port = SerialPort::open(file_);
    if (!port) return tl::unexpected(port.error());
    port_ = std::move(*port);
    reader_.forget();
    trouble_ = Trouble::None;
    boardsError_ = 0;
    auto ready = meet().and_then([this] { return firstPlace(); });
    if (!ready) {
        port_->sendNow(noForce());
        port_.reset();
        return ready;
    }
    staleTicks_ = silentTicks_ = 0;
    ask();
    way_ = port_.get();
    return {};
}

/// Both kinds of boards answer the newer greeting: it means no current to one, and nothing to the other.
Result<void> Polhem::meet() {
    bool met = false;
    counts_ = {};
    const bool answered = wait([&](int passed) {
        if (passed % kAskEvery == 0) port_->send(currentLine(Vec3::Zero()));
        std::array<char, 256> room{};
        reader_.take(port_->receive(room), [&](std::string_view line) {
            const auto counts = countsIn(line);
            if (counts) counts_ = *counts;
            if (!counts && !isOfPlaces(line)) return;
            speech_ = counts ? PolhemSpeech::Currents : PolhemSpeech::Forces;
            met = true;
        });
        return met || port_->gone();
    });
    if (answered && met && (speech_ == PolhemSpeech::Forces || counts_.model == kModel)) return {};
    if (met)
        return machineError("The board at " + inQuotes(file_.string()) +
                            " drives another arm of its maker (model " + std::to_string(counts_.model) +
                            "), which Tactum does not know: choose another device.");
    return machineError(
        "What is at " + inQuotes(file_.string()) +
        " does not answer as a Polhem does: look at its cable and its power, or choose another device.");
}

Result<void> Polhem::firstPlace() {
    silentTicks_ = 0;
    const bool there = wait([&](int passed) {
        if (passed % kAskEvery == 0) port_->send(noForce()); // ends what the greeting has left, too
        ++silentTicks_;
        return read() || port_->gone();
    });
    if (there && !port_->gone()) return {};
    if (port_->gone() || silentTicks_ > 2 * kAskEvery)
        return machineError(profile_.name + " stopped answering: look at its cable and plug it in again.");
    return machineError(profile_.name +
                        " says that it is where its arm cannot be, for it counts from where the arm "
                        "was when it got power: put the arm into its rest, and plug it in again.");
}

void Polhem::close() {
    SerialPort* const port = way_.exchange(nullptr);
    if (!port) return;
    port->sendNow(noForce());
    port_.reset();
}

// ---- The servo's exchange

/// Each answer is asked for by the command before: the arm was there then.
DeviceSample Polhem::exchange(const DeviceCommand& wanted, double) noexcept {
    if (!way_.load(std::memory_order_relaxed)) return {}; // closed
    const bool fresh = read();
    judge(fresh);
    if (fresh)
        command(limit_(wanted.force));
    else if (staleTicks_ % kAskAgain == 0)
        ask();
    DeviceSample sample;
    sample.position = position_;
    sample.valid = fresh;
    return sample;
}

/// Whether a new place came.
bool Polhem::read() noexcept {
    bool fresh = false;
    std::array<char, 1024> room;
    reader_.take(port_->receive(room), [&](std::string_view line) { fresh = understand(line) || fresh; });
    return fresh;
}

bool Polhem::understand(std::string_view line) noexcept {
    silentTicks_ = 0;
    if (speech_ == PolhemSpeech::Forces) {
        const auto place = placeIn(line);
        if (!place) return false;
        position_ = place->position;
        turn(place->angles[0], place->angles[1], {place->angles[2], place->angles[3], 0});
        return true;
    }
    const auto counts = countsIn(line);
    if (!counts || counts->model != kModel) return false;
    counts_ = *counts;
    boardsError_ = counts->error;
    const Vec3 joints = jointsOf(arm_, counts->encoders);
    const auto place = positionOf(arm_, joints);
    if (!place) return false;
    position_ = *place;
    turn(joints[0], forearmOf(arm_, joints), wristOf(arm_, counts->encoders));
    return true;
}

void Polhem::turn(double column, double forearm, const Vec3& wrist) noexcept {
    const Quat turned = turnOf(column, forearm, wrist);
    handle_.turns = turned.coeffs().allFinite();
    if (handle_.turns) handle_.orientation = turned;
}

void Polhem::judge(bool fresh) noexcept {
    staleTicks_ = fresh ? 0 : staleTicks_ + 1;
    ++silentTicks_;
    Trouble found = Trouble::None;
    if (port_->gone())
        found = Trouble::Gone;
    else if (staleTicks_ > kSilentTicks)
        found = silentTicks_ > kSilentTicks ? Trouble::Silent : Trouble::Lost;
    trouble_ = found;
}

void Polhem::command(const Vec3& force) noexcept {
    if (speech_ == PolhemSpeech::Forces)
        port_->send(forceLine(force));
    else
        port_->send(currentLine(currentsFor(arm_, force, jointsOf(arm_, counts_.encoders))));
}

/// Without any force, where the arm may be anywhere: an answer was lost.
void Polhem::ask() noexcept {
    if (speech_ == PolhemSpeech::Forces)
        port_->send(forceLine(Vec3::Zero()));
    else
        port_->send(currentLine(Vec3::Zero()));
}

std::string_view Polhem::noForce() const noexcept {
    return speech_ == PolhemSpeech::Forces ? kNoForce : kNoCurrent;
}

void Polhem::emergencyStop() noexcept {
    if (const SerialPort* const way = way_) way->sendNow(noForce());
}

std::string Polhem::trouble() const {
    switch (trouble_) {
    case Trouble::None:
        return {};
    case Trouble::Gone:
        return profile_.name + " was unplugged. Put its arm into its rest, plug it in and open it again.";
    case Trouble::Silent:
        return profile_.name + " says nothing any more. Look at its USB cable and its power.";
    case Trouble::Lost:
        return profile_.name +
               " says places where its arm cannot be. Put the arm into its rest, and plug it in again.";
    }
    return {};
}

std::string Polhem::caution() const {
    std::string text;
    if (const int error = boardsError_)
        text = "Its board says error " + std::to_string(error) +
               "; its maker has not published what that means. ";
    if (way_ && speech_ == PolhemSpeech::Currents)
        text += "Whether its board takes the force away when nobody commands it is not published.";
    return text;
}

} // namespace tactum
