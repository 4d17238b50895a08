#include "core/study/touch_log.h"

#include "core/base/numbers.h"

namespace tactum {

namespace {
constexpr double kGap = 0.1; // s: ticks were lost, or the servo began anew
}

std::string TouchLog::header() {
    return "t_s,trial,interval,finger_x_m,finger_y_m,finger_z_m,proxy_x_m,proxy_y_m,proxy_z_m,velocity_x_m_"
           "per_s,"
           "velocity_y_m_per_s,velocity_z_m_per_s,force_x_N,force_y_N,force_z_N,touching\n";
}

void TouchLog::add(std::string& rows, const TouchTick& tick, int trial, int interval) {
    const std::optional<TouchTick> before = before_;
    before_ = tick;
    const double dt = before ? tick.t - before->t : 0;
    if (dt <= 0 || dt > kGap) {
        passed_ = every_; // the next one has a velocity again
        return;
    }
    if (++passed_ < every_) return;
    passed_ = 0;
    const Vec3 velocity = (tick.finger - before->finger) / dt;
    appendNumber(rows, tick.t);
    rows += ',' + std::to_string(trial) + ',' + std::to_string(interval);
    for (const Vec3& v : {tick.finger, tick.proxy, velocity, tick.force})
        for (const double value : v) {
            rows += ',';
            appendNumber(rows, value);
        }
    rows += tick.touching ? ",1\n" : ",0\n";
}

} // namespace tactum
