#include "core/vibration/second_order.h"

#include <cmath>
#include <numbers>

namespace tactum {
namespace {

struct Corner {
    double k, norm;

    Corner(double corner, double rate)
        : k(std::tan(std::numbers::pi * corner / rate)), norm(1 / (1 + std::numbers::sqrt2 * k + k * k)) {}
    std::array<double, 3> feedback() const {
        return {1, 2 * (k * k - 1) * norm, (1 - std::numbers::sqrt2 * k + k * k) * norm};
    }
};

} // namespace

SecondOrder SecondOrder::highPass(double corner, double rate) {
    const Corner at(corner, rate);
    SecondOrder filter;
    filter.b_ = {at.norm, -2 * at.norm, at.norm};
    filter.a_ = at.feedback();
    return filter;
}

SecondOrder SecondOrder::lowPass(double corner, double rate) {
    const Corner at(corner, rate);
    const double gain = at.k * at.k * at.norm;
    SecondOrder filter;
    filter.b_ = {gain, 2 * gain, gain};
    filter.a_ = at.feedback();
    return filter;
}

Vec3 SecondOrder::operator()(const Vec3& in) {
    const Vec3 now = b_[0] * in + b_[1] * in_[0] + b_[2] * in_[1] - a_[1] * out_[0] - a_[2] * out_[1];
    in_ = {in, in_[0]};
    out_ = {now, out_[0]};
    return now;
}

void SecondOrder::settle(const Vec3& in, const Vec3& out) {
    in_ = {in, in};
    out_ = {out, out};
}

} // namespace tactum
