#include "core/study/touch_log.h"

#include "core/study/log_row.h"

namespace tactum {

namespace {

constexpr double kGap = 0.1; // s: ticks were lost, or the servo began anew
/// In the order of ContactFriction.
constexpr const char* kFrictionNames[kContactFrictions] = {"none", "stick", "slip", "smooth"};

struct TouchedNames {
    std::string_view object, surface;
};

TouchedNames namesOf(const TouchedPlace& touched, const Scene* scene) {
    const SceneObject* object = scene && touched.contacts > 0 ? scene->find(touched.object) : nullptr;
    if (!object || touched.surface >= object->surfaces.size()) return {};
    return {object->name, object->surfaces[touched.surface].name};
}

} // namespace

std::string TouchLog::header() {
    return "format,t_s,trial,interval,hand,condition,value,scene_revision,"
           "finger_x_m,finger_y_m,finger_z_m,proxy_x_m,proxy_y_m,proxy_z_m,"
           "velocity_x_m_per_s,velocity_y_m_per_s,velocity_z_m_per_s,"
           "force_x_N,force_y_N,force_z_N,wanted_x_N,wanted_y_N,wanted_z_N,normal_N,tangential_N,"
           "gain,clipped,touching,contacts,object,surface,friction\n";
}

void TouchLog::add(std::string& rows, const TracePoint& tick, const TouchMoment& moment) {
    const std::optional<Before> before = before_;
    before_ = {tick.t, tick.finger};
    const double dt = before ? tick.t - before->t : 0;
    if (dt <= 0 || dt > kGap) {
        passed_ = every_; // the next one has a velocity again
        return;
    }
    if (++passed_ < every_) return;
    passed_ = 0;
    const TouchedNames names = namesOf(tick.touched, moment.scene);
    LogRow row;
    row.text(kStudyLogVersion).number(tick.t).number(moment.trial).number(moment.interval);
    row.number(moment.hand).text(moment.condition);
    row.maybe(moment.value.has_value(), moment.value.value_or(0)).whole(tick.revision);
    row.vector(tick.finger).vector(tick.proxy).vector((tick.finger - before->finger) / dt);
    row.vector(tick.force).vector(tick.wanted).number(tick.normalForce).number(tick.tangentialForce);
    row.number(tick.gain).number(tick.limited).number(tick.touching).number(tick.touched.contacts);
    row.text(names.object).text(names.surface).text(kFrictionNames[std::size_t(tick.touched.friction)]);
    rows += row.line();
}

} // namespace tactum
