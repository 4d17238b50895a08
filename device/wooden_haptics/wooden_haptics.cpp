#include "device/wooden_haptics/wooden_haptics.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "core/base/realtime.h"

namespace tactum {

namespace {

/// HID's interrupt endpoints as the board's USB library numbers them. A packet of just one report: a longer
/// one, of a firmware that speaks another protocol, is then an error and not misread.
constexpr UsbEndpoints kEndpoints{.interface = 0, .in = 0x81, .out = 0x01, .interrupt = true, .packet = 8};

const char kConnect[] = "Connect";
const char kRest[] = "Rest position";
const char kRestRequest[] =
    "Move the arm, then put it into its rest position, the upper arm upright and the forearm "
    "hanging straight down, and hold it there for two seconds.";

constexpr int kSilence = 1000;   ///< ms without a report: it does not work
constexpr int kMoved = 100;      ///< counts: somebody moves the arm on purpose
constexpr int kStillWithin = 10; ///< counts, of an arm that is held still
constexpr int kStillFor = 2000;  ///< reports, 2 s

constexpr int kMaxLost = 100;   ///< reports between two; more, and it began to count anew
constexpr int kStaleTicks = 10; ///< so many without a report, and the arm may be anywhere: no current
constexpr int kSilentTicks = 50;
constexpr int kUnheard = 20; ///< commands in a row

int apart(std::int16_t a, std::int16_t b) noexcept {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(a) - static_cast<std::uint16_t>(b));
}

/// The farthest that a motor is from where it was.
int distance(const Counts& a, const Counts& b) noexcept {
    return std::max({std::abs(apart(a[0], b[0])), std::abs(apart(a[1], b[1])), std::abs(apart(a[2], b[2]))});
}

/// Waits until an arm was moved and then held still. Nothing about it is absolute, so where it stands is only
/// its rest position because somebody says so: he moves it first, on purpose.
class RestGesture {
public:
    /// `enough`: reports that it has to be held still for.
    RestGesture(const Counts& first, int enough) : first_(first), held_(first), enough_(enough) {}

    void see(const Counts& counts) {
        moved_ = moved_ || distance(counts, first_) > kMoved;
        if (!moved_ || distance(counts, held_) > kStillWithin) {
            held_ = counts;
            sum_ = {};
            still_ = 0;
        }
        for (std::size_t i = 0; i < 3; ++i)
            sum_[i] += apart(counts[i], held_[i]);
        ++still_;
    }
    double done() const { return moved_ ? static_cast<double>(still_) / enough_ : 0; }
    /// The middle of where it was held, since no hand is quite still.
    Counts rest() const {
        Counts rest = held_;
        for (std::size_t i = 0; i < 3; ++i) {
            const long off = std::lround(static_cast<double>(sum_[i]) / still_);
            rest[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(held_[i] + off));
        }
        return rest;
    }

private:
    Counts first_, held_;
    int enough_;
    bool moved_ = false;
    int still_ = 0;
    std::array<int, 3> sum_{};
};

/// What was plugged in again is another place on the bus, but in the same socket.
UsbPlace placeNow(const UsbPlace& before) {
    const UsbId wanted[] = {before.id};
    if (const auto places = listUsb(wanted))
        for (const UsbPlace& place : *places)
            if (place.port == before.port) return place;
    return before;
}

} // namespace

WoodenHaptics::WoodenHaptics(const UsbPlace& place, DeviceInfo profile)
    : place_(place), profile_(std::move(profile)) {}

WoodenHaptics::~WoodenHaptics() {
    close();
}

// ---- Making it ready

std::vector<std::string> WoodenHaptics::steps() const {
    return {kConnect, kRest};
}

Result<void> WoodenHaptics::prepare(Opening& opening) {
    assertNotRealtime();
    if (link_ && link_->gone()) {
        link_.reset();
        prepared_ = false;
    }
    if (auto connected = connect(opening); !connected) return connected;
    return prepared_ ? Result<void>{} : findRest(opening);
}

Result<void> WoodenHaptics::connect(Opening& opening) {
    if (link_) return {};
    opening.begin(kConnect);
    auto link = UsbLink::open(placeNow(place_), kEndpoints);
    if (!link) return tl::unexpected(link.error());
    link_ = std::move(*link);
    return {};
}

Result<void> WoodenHaptics::findRest(Opening& opening) {
    opening.begin(kRest, kRestRequest);
    if (auto started = link_->startStream(); !started) return started;
    Result<WoodenReport> report = waitForReport(opening);
    if (report) {
        RestGesture gesture(report->values, kStillFor);
        while (report && gesture.done() < 1) {
            gesture.see(report->values);
            opening.progress(gesture.done());
            report = waitForReport(opening);
        }
        rest_ = gesture.rest();
    }
    link_->stopStream();
    if (!report) return tl::unexpected(report.error());
    prepared_ = true;
    return {};
}

/// The next one. Zero currents go out meanwhile.
Result<WoodenReport> WoodenHaptics::waitForReport(Opening& opening) {
    for (int waited = 0; waited < kSilence; ++waited) {
        if (opening.cancelled())
            return inputError(profile_.name +
                              " needs a hand: its rest position is not known. Prepare it, and "
                              "put the arm there when asked.");
        command(Vec3::Zero());
        if (const auto report = decode(link_->take())) return *report;
        link_->poll();
        if (link_->gone())
            return machineError(profile_.name + " was unplugged; plug it in and prepare it again.");
        if (const auto report = decode(link_->take())) return *report;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return machineError(profile_.name + " says nothing; is its board running, and the USB cable all right?");
}

Result<void> WoodenHaptics::open() {
    Unattended nobody;
    if (auto ready = prepare(nobody); !ready) return ready;
    newest_ = {};
    heard_ = false;
    staleTicks_ = sameCounter_ = 0;
    trouble_ = Trouble::None;
    if (auto started = link_->startStream(); !started) return started;
    command(Vec3::Zero());
    stopWay_ = link_.get();
    return {};
}

void WoodenHaptics::close() {
    if (!stopWay_.exchange(nullptr)) return;
    link_->sendNow(encode({})); // comes after whatever is under way
    link_->stopStream();
    if (trouble_ == Trouble::Restarted) prepared_ = false;
}

// ---- The servo's exchange

DeviceSample WoodenHaptics::exchange(const DeviceCommand& wanted, double) noexcept {
    if (!stopWay_.load(std::memory_order_relaxed)) return {}; // closed
    const bool fresh = readReports();
    judge(fresh);
    const bool usable = heard_ && staleTicks_ < kStaleTicks && trouble_ != Trouble::Restarted;
    const Vec3 joints = jointsOf(arm_, newest_.values, rest_);
    command(usable ? currentsFor(arm_, wanted.force, joints) : Vec3::Zero());
    DeviceSample sample;
    sample.position = positionOf(arm_, joints);
    sample.valid = fresh && usable;
    return sample;
}

/// Whether a new one came.
bool WoodenHaptics::readReports() noexcept {
    link_->poll();
    bool fresh = false;
    for (auto bytes = link_->take(); !bytes.empty(); bytes = link_->take())
        if (const auto report = decode(bytes)) fresh = accept(*report) || fresh;
    return fresh;
}

bool WoodenHaptics::accept(const WoodenReport& report) noexcept {
    const auto ahead = static_cast<std::uint16_t>(report.counter - newest_.counter);
    if (heard_ && ahead == 0) {
        ++sameCounter_;
        return false;
    }
    if (heard_ && ahead > kMaxLost)
        trouble_ = Trouble::Restarted; // and its encoders count from somewhere else
    newest_ = report;
    heard_ = true;
    sameCounter_ = 0;
    return true;
}

void WoodenHaptics::judge(bool fresh) noexcept {
    staleTicks_ = fresh ? 0 : staleTicks_ + 1;
    if (trouble_ == Trouble::Restarted) return; // until somebody puts it into its rest position again
    Trouble found = Trouble::None;
    if (link_->gone())
        found = Trouble::Gone;
    else if (staleTicks_ > kSilentTicks)
        found = sameCounter_ > 0 ? Trouble::Frozen : Trouble::Silent;
    else if (link_->failures() > kUnheard)
        found = Trouble::Deaf;
    trouble_ = found;
}

void WoodenHaptics::command(const Vec3& currents) noexcept {
    WoodenReport report;
    report.values = milliamperes(currents);
    report.counter = static_cast<std::uint16_t>(sent_ + 1);
    if (link_->send(encode(report))) sent_ = report.counter;
}

void WoodenHaptics::emergencyStop() noexcept {
    if (UsbLink* way = stopWay_) way->sendNow(encode({}));
}

std::string WoodenHaptics::trouble() const {
    switch (trouble_) {
    case Trouble::None:
        return {};
    case Trouble::Gone:
        return profile_.name + " was unplugged. Plug it in and prepare it again.";
    case Trouble::Silent:
        return profile_.name + " says nothing any more. Look at its USB cable and its board.";
    case Trouble::Frozen:
        return profile_.name +
               " repeats itself: its board hangs. Unplug it, plug it in and prepare it again.";
    case Trouble::Restarted:
        return profile_.name + " began to count anew, so nobody knows where its arm is. Prepare it again.";
    case Trouble::Deaf:
        return profile_.name + " does not take its commands. Look at its USB cable and its board.";
    }
    return {};
}

} // namespace tactum
