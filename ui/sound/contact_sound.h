// The force of a contact as sound: texture can be judged by ear where there is no device.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/vec.h"
#include "core/vibration/second_order.h"

namespace tactum {

inline constexpr int kSoundRate = 48000; ///< samples/s

/// What is heard is what a device would shake with, and nothing is made up: the force at the servo's rate,
/// its slow part below 20 Hz taken away, interpolated to 48 kHz without images above half the servo's rate.
/// Of the three directions the one in which the force shakes most is heard; it is followed slowly, so that
/// one frequency stays one. (Noise shaped by the speed of sliding would sound richer, but of every texture
/// alike.) About 8 ticks late. Louder than full scale is bent to stay below it. Thread: any but real time,
/// one.
class ContactSound {
public:
    /// servoRate in Hz, from 100 to 48000.
    explicit ContactSound(double servoRate = 1000);

    /// The samples, from -1 to 1, that have become known by these ticks. Forces in N; what is not finite is
    /// taken for what was before it. The first tick is taken for a force that has been there for ever.
    std::vector<float> operator()(std::span<const Vec3> forces);

private:
    static constexpr int kTaps = 16, kPhases = 256;

    void tick(const Vec3& force, std::vector<float>& out);
    double shaking(const Vec3& force);

    double perSample_; ///< ticks of one sample
    SecondOrder shaking_;
    Vec3 direction_ = Vec3::Zero();
    bool begun_ = false;
    Vec3 last_ = Vec3::Zero();
    double follow_;                      ///< part of a tick's shaking that turns the direction
    double level_ = 0;                   ///< N^2, of the last tenth of a second
    std::array<double, kTaps> recent_{}; ///< newest last
    double next_ = 0;                    ///< ticks until the next sample
    std::vector<std::array<float, kTaps>> kernel_;
};

} // namespace tactum
