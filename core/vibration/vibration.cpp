#include "core/vibration/vibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include <unsupported/Eigen/FFT>

namespace tactum {
namespace {

using Samples = std::vector<double>;
using Spectrum = std::vector<std::complex<double>>;

constexpr double kPlayedRate = 8000;
/// s by which the signal is longer than the stroke: its end eases into its beginning, because a spectrum is
/// of what repeats itself. Far slower than what is kept.
constexpr double kEasing = 0.25;

/// The rate of rows that come evenly, or the mean of those that do not; 1, 2, 4 or 8 kHz, no slower than they
/// are.
double rateOf(const TouchTrace& rows) {
    const double given = double(rows.size() - 1) / (rows.back().t - rows.front().t);
    double rate = 1000;
    while (rate < kPlayedRate && rate < given * 0.999)
        rate *= 2;
    return rate;
}

/// One axis at even times, and on to `length` by the easing.
Samples evenly(const TouchTrace& rows, int axis, double rate, std::size_t count, std::size_t length) {
    Samples samples(length);
    std::size_t next = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = rows.front().t + double(i) / rate;
        while (next + 1 < rows.size() && rows[next].t < t)
            ++next;
        const TouchRow &a = rows[next - 1], &b = rows[next];
        const double part = b.t > a.t ? std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0) : 1;
        samples[i] = a.force[axis] + part * (b.force[axis] - a.force[axis]);
    }
    const double end = samples[count - 1], start = samples[0];
    for (std::size_t i = count; i < length; ++i) {
        const double part = double(i - count + 1) / double(length - count + 1);
        samples[i] = end + (start - end) * (1 - std::cos(std::numbers::pi * part)) / 2;
    }
    return samples;
}

/// A Butterworth filter of second order run forth and back, in other words without a delay.
double kept(double frequency) {
    const double ratio = kSlowestVibration / std::max(frequency, 1e-9);
    return 1 / (1 + std::pow(ratio, 4));
}

/// The lower half of DFT321's spectrum.
Spectrum oneOf(const std::array<Spectrum, 3>& axes, double rate) {
    const std::size_t length = axes[0].size();
    Spectrum one(length / 2 + 1);
    for (std::size_t i = 1; i < one.size(); ++i) {
        std::complex<double> sum = 0;
        double power = 0;
        for (const Spectrum& axis : axes) {
            sum += axis[i];
            power += std::norm(axis[i]);
        }
        one[i] = std::polar(std::sqrt(power) * kept(double(i) * rate / double(length)), std::arg(sum));
    }
    return one;
}

/// The signal of a spectrum's lower half at `times` its rate: nothing is added between the samples but what
/// they say.
Samples played(const Spectrum& lower, std::size_t length, std::size_t times) {
    Spectrum whole(length * times);
    for (std::size_t i = 1; i < length / 2; ++i) {
        whole[i] = lower[i] * double(times);
        whole[whole.size() - i] = std::conj(whole[i]);
    }
    Spectrum signal;
    Eigen::FFT<double>().inv(signal, whole);
    Samples samples(signal.size());
    std::ranges::transform(signal, samples.begin(), [](const std::complex<double>& z) { return z.real(); });
    return samples;
}

} // namespace

Result<Vibration> vibrationOf(const TouchTrace& rows) {
    if (rows.size() < 2 || !(rows.back().t > rows.front().t))
        return inputError("the stroke has no length in time; a vibration needs two rows or more");
    const double seconds = rows.back().t - rows.front().t;
    if (seconds > kLongestVibration)
        return inputError("the stroke is longer than ten minutes; give a shorter one for its vibration");
    const double rate = rateOf(rows);
    const std::size_t count = std::size_t(seconds * rate + 0.5) + 1;
    std::size_t length = 1;
    while (double(length) < double(count) + kEasing * rate)
        length *= 2;
    std::array<Spectrum, 3> axes;
    for (int axis = 0; axis < 3; ++axis)
        Eigen::FFT<double>().fwd(axes[std::size_t(axis)], evenly(rows, axis, rate, count, length));
    const std::size_t times = std::size_t(kPlayedRate / rate);
    Vibration vibration{kPlayedRate, played(oneOf(axes, rate), length, times)};
    vibration.force.resize((count - 1) * times + 1);
    return vibration;
}

double peakOf(const Vibration& vibration) {
    double peak = 0;
    for (const double force : vibration.force)
        peak = std::max(peak, std::abs(force));
    return peak;
}

} // namespace tactum
