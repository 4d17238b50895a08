// How much of a force sounds, and above which frequency.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace tactum::test {

/// Mean square of a sequence above a frequency, and in all but its slowest waves.
struct Spectrum {
    double above = 0, whole = 0;
};

inline Spectrum spectrumOf(const std::vector<double>& values, double rate, double frequency) {
    Spectrum result;
    const std::size_t n = values.size();
    for (std::size_t k = 1; k <= n / 2; ++k) {
        double re = 0, im = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double window = 1 - std::cos(2 * std::numbers::pi * double(i) / double(n)); // Hann
            const double angle = 2 * std::numbers::pi * double(k * i % n) / double(n);
            re += window * values[i] * std::cos(angle), im += window * values[i] * std::sin(angle);
        }
        const double energy = 2 * (re * re + im * im) / (1.5 * double(n) * double(n));
        result.whole += k < 4 ? 0 : energy;
        if (double(k) * rate / double(n) > frequency) result.above += energy;
    }
    return result;
}

} // namespace tactum::test
