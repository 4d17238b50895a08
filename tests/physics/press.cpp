#include "tests/physics/press.h"

#include <algorithm>

namespace tactum::test {
namespace {

constexpr double kWatched = 0.5, kCalmedDown = 1; ///< s
constexpr double kRunUp = 0.002;                  ///< m

struct Range {
    double low = 1e300, high = -1e300;
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    double width() const { return high < low ? 0 : high - low; }
};

Rest watch(ClosedLoop& loop, double seconds) {
    Rest rest;
    Range motion, force;
    double sum = 0;
    int count = 0;
    bool touched = false;
    loop.run(seconds, [&](const ClosedLoop& now) {
        rest.given = std::max(rest.given, now.plant.given());
        rest.peak = std::max(rest.peak, now.command.norm());
        if (now.time > kCalmedDown) {
            rest.lost |= touched && now.command.z() <= 0;
            touched |= now.command.z() > 0;
        }
        if (now.time < seconds - kWatched) return;
        motion.add(now.plant.x[2]);
        force.add(now.command.z());
        sum += now.command.z();
        ++count;
    });
    rest.motion = motion.width();
    rest.force = force.width();
    rest.steady = sum / std::max(count, 1);
    return rest;
}

void begin(ClosedLoop& loop, const Press& press) {
    loop.plant.place({0, 0, press.impact > 0 ? kRunUp : 0}, {0, 0, -press.impact});
    loop.plant.setGoal(Vec3::Zero());
    loop.plant.voluntary.z() = -press.force;
}

} // namespace

Rest pressPlain(const Bench& bench, const Press& press, double stiffness, double seconds) {
    const LocalContactModel model = wall(stiffness, press.damping);
    ClosedLoop loop(bench, [&](const DeviceSample& sample, double) {
        return contactModelForce(model, sample.position, sample.velocity);
    });
    begin(loop, press);
    Rest rest = watch(loop, seconds);
    rest.stiffness = stiffness;
    return rest;
}

Rest pressServo(const Bench& bench, const Press& press, double stiffness, double seconds,
                const std::function<void(Servo&)>& prepare) {
    GivenModel model(wall(stiffness, press.damping));
    Servo servo(infoOf(bench), model);
    if (prepare) prepare(servo);
    ClosedLoop loop(bench, servo.control());
    begin(loop, press);
    loop.warmUp();
    Rest rest = watch(loop, seconds);
    rest.stiffness =
        servo.state.schedule.scale() * std::min(stiffness, servo.settings.overrideCeiling
                                                               ? stiffness
                                                               : servo.state.schedule.ceiling().value);
    return rest;
}

} // namespace tactum::test
