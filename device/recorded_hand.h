// A finger that plays a recording and feels nothing: for demonstrations, tests and pictures.
#pragma once

#include <vector>

#include "core/port/haptic_device.h"

namespace tactum {

/// Where the recorded finger was at a time. Frame D; s, m.
struct RecordedPoint {
    double t = 0;
    Vec3 position = Vec3::Zero();
};

enum class Playback : unsigned char {
    Once,  ///< after its end the finger rests at the last point, still valid: a contact stays to be looked at
    Looped ///< starts again at the first point, without the time between the last and the first
};

/// Straight lines between the points at the recorded pace; the force is ignored. The first exchange after
/// open() reads the first point; from then on the recording advances by the dt of each exchange.
class RecordedHand final : public HapticDevice {
public:
    explicit RecordedHand(std::vector<RecordedPoint> points, Playback playback = Playback::Once);

    DeviceInfo info() const override;
    /// Rewinds. Fails when there is no point, one is not finite, or t does not rise strictly.
    Result<void> open() override;
    void close() override;
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override;

private:
    double playedTime() const noexcept;

    std::vector<RecordedPoint> points_;
    Playback playback_;
    double elapsed_ = 0; ///< s since the first exchange
    bool rewound_ = true;
};

} // namespace tactum
