#include "ui/widgets/touch_history.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace tactum {

namespace {

constexpr double kWindow = 0.01;    // s, over which a slip is judged
constexpr double kSlipSpeed = 2e-3; // m/s; a proxy that sticks to a model at rest does not move at all
constexpr std::size_t kRateTicks = 100;
constexpr double kJump = 0.5;      // s
constexpr double kMinForce = 1e-3; // N: no ratio of less

const ContactReport* most(const HapticOutput& touch) {
    const ContactReport* found = nullptr;
    for (int i = 0; i < std::clamp(touch.contacts, 0, kMaxModelPlanes); ++i) {
        const ContactReport& contact = touch.contact[std::size_t(i)];
        if (!found || contact.normalForce > found->normalForce) found = &contact;
    }
    return found;
}

} // namespace

void TouchHistory::add(const std::vector<TracePoint>& points, const TouchFrame& frame) {
    const ContactReport* contact = frame.touch ? most(*frame.touch) : nullptr;
    for (const TracePoint& point : points) {
        if (!samples_.empty() && (point.t <= end() || point.t > end() + kJump)) clear();
        TouchSample s{.t = point.t, .finger = point.finger, .proxy = point.proxy, .force = point.force};
        s.magnitude = point.force.norm();
        s.normal = point.normalForce;
        s.tangential = point.tangentialForce;
        s.touching = point.touching;
        s.ratio = s.normal > kMinForce ? s.tangential / s.normal : 0;
        if (contact && s.touching) {
            s.staticFriction = contact->staticFriction;
            s.dynamicFriction = contact->dynamicFriction;
        }
        if (s.touching) s.surface = numberOf(frame.surface);
        s.lag = (point.proxy - point.finger).norm();
        s.energy = point.energy;
        s.servoRate = rate(point.t);
        s.proxyRate = frame.proxyRate;
        (frame.body.turns ? s.jointAngle : s.jointWay) = frame.body.value;
        (frame.body.turns ? s.jointTurning : s.jointSpeed) = frame.body.rate;
        (frame.body.turns ? s.jointTorque : s.jointForce) = frame.body.force;
        s.kinetic = frame.body.kinetic;
        s.potential = frame.body.potential;
        s.slipping = s.touching && slips(s);
        samples_.push_back(s);
    }
    while (!samples_.empty() && end() - samples_.front().t > kSpan)
        samples_.pop_front();
}

// From where the proxy was at each tick: a slip is often over before the next frame could see it.
bool TouchHistory::slips(const TouchSample& now) const {
    for (auto before = samples_.rbegin(); before != samples_.rend(); ++before) {
        const double duration = now.t - before->t;
        if (duration < kWindow) continue;
        return before->touching && (now.proxy - before->proxy).norm() > kSlipSpeed * duration;
    }
    return false;
}

double TouchHistory::rate(double t) const {
    const std::size_t ticks = std::min(kRateTicks, samples_.size());
    if (ticks == 0) return 0;
    return double(ticks) / (t - samples_[samples_.size() - ticks].t);
}

std::uint32_t TouchHistory::numberOf(const std::string& name) {
    const auto known = std::ranges::find(names_, name);
    const auto number = std::uint32_t(known - names_.begin());
    if (known == names_.end()) names_.push_back(name);
    return number;
}

const TouchSample* TouchHistory::at(double t) const {
    if (samples_.empty()) return nullptr;
    const auto after = std::ranges::lower_bound(samples_, t, {}, &TouchSample::t);
    if (after == samples_.begin()) return &samples_.front();
    if (after == samples_.end()) return &samples_.back();
    const auto before = std::prev(after);
    return t - before->t <= after->t - t ? &*before : &*after;
}

std::string csvOf(const TouchHistory& history, double from) {
    std::string csv = "time (s),finger x (m),finger y (m),finger z (m),proxy x (m),proxy y (m),proxy z (m),"
                      "force x (N),force y (N),force z (N),force (N),normal force (N),tangential force (N),"
                      "friction ratio,static friction,dynamic friction,proxy lag (m),energy (J),"
                      "servo rate (Hz),proxy rate (Hz),joint angle (rad),joint way (m),"
                      "joint turning (rad/s),joint speed (m/s),joint torque (N m),joint force (N),kinetic "
                      "energy (J),potential energy (J),"
                      "touching,slipping\n";
    const auto& samples = history.samples();
    auto row = std::ranges::lower_bound(samples, from, {}, &TouchSample::t);
    const double begin = row == samples.end() ? 0 : row->t;
    for (; row != samples.end(); ++row) {
        const TouchSample& s = *row;
        appendNumber(csv, s.t - begin);
        for (const double value :
             {s.finger.x(), s.finger.y(),     s.finger.z(),      s.proxy.x(),    s.proxy.y(),  s.proxy.z(),
              s.force.x(),  s.force.y(),      s.force.z(),       s.magnitude,    s.normal,     s.tangential,
              s.ratio,      s.staticFriction, s.dynamicFriction, s.lag,          s.energy,     s.servoRate,
              s.proxyRate,  s.jointAngle,     s.jointWay,        s.jointTurning, s.jointSpeed, s.jointTorque,
              s.jointForce, s.kinetic,        s.potential}) {
            csv += ',';
            appendNumber(csv, value);
        }
        csv += s.touching ? ",1" : ",0";
        csv += s.slipping ? ",1\n" : ",0\n";
    }
    return csv;
}

} // namespace tactum
