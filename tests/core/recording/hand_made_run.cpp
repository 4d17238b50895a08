#include "tests/core/recording/hand_made_run.h"

#include <fstream>
#include <functional>

#include "core/haptics/compile.h"
#include "core/runtime/recorder.h"
#include "tests/realtime/bumpy_scene.h"

namespace tactum {
namespace {

constexpr double kTick = 1e-3, kStep = 5e-4;
constexpr int kEdit = 40; ///< ms between two edits

/// Both loops in one thread, as the engine runs them.
class Loops {
public:
    explicit Loops(std::shared_ptr<const World> world) : servo_(device()) { take(std::move(world)); }

    static DeviceInfo device() {
        return {.name = "Hand-made", .maxForce = 8, .rate = 1000, .damping = 1e5, .tripSpeed = 20};
    }
    void take(std::shared_ptr<const World> world) {
        world_ = std::move(world);
        scenes_.push_back({numbersOf(*world_), world_->scene});
    }
    const World* world() const { return world_.get(); }

    void step(double time, bool restart) {
        ProxyRow row{.time = time,
                     .dt = kStep,
                     .finger = tripleOf(finger_.position),
                     .velocity = tripleOf(finger_.velocity),
                     .world = world_->revision,
                     .anchoring = finger_.anchoring,
                     .flags = restart || finger_.anchoring != sim_.model.anchoring
                                  ? std::uint32_t(ProxyRow::Restart)
                                  : 0};
        recorder_.begin(row, sim_);
        note(row, stepFrom(row, *world_, sim_));
        recorder_.end(row);
        fresh_ = true;
    }
    void tick(double time, bool credible) {
        const Vec3 at = wanderingFinger(4 * time);
        ServoRow row{.time = time,
                     .dt = kTick,
                     .apart = kTick,
                     .position =
                         tripleOf(credible ? at : Vec3(at + Vec3::UnitX())), // a metre off: it cannot be
                     .velocity = tripleOf((at - wanderingFinger(4 * (time - kTick))) / kTick),
                     .model = recorder_.proxyCount(),
                     .flags = std::uint32_t(ServoRow::Armed) | std::uint32_t(ServoRow::Valid) |
                              (fresh_ ? ServoRow::Fresh : 0u)};
        recorder_.begin(row, servo_);
        const ServoOutput output = stepFrom(row, servo_, sim_.model);
        note(row, output, servo_);
        recorder_.end(row);
        fresh_ = false;
        if (output.finger.valid) finger_ = output.finger;
    }
    RecordedRun recorded() const {
        RecordedRun run = recorder_.copy();
        run.device = device();
        run.scenes = scenes_;
        trim(run);
        return run;
    }

private:
    Recorder recorder_{1000, 2000};
    std::shared_ptr<const World> world_;
    std::vector<RecordedScene> scenes_;
    SimState sim_;
    ServoState servo_;
    FingerSample finger_;
    bool fresh_ = false;
};

RecordedRun run(int milliseconds, const std::function<Scene(int)>& sceneAt) {
    Loops loops(compile(sceneAt(0)).value());
    for (int i = 0; i < milliseconds; ++i) {
        const double time = kTick * i;
        const bool lost = i > milliseconds / 2 && i < milliseconds / 2 + 5;
        loops.tick(time, !lost);
        if (i % kEdit == kEdit - 1) loops.take(compile(sceneAt(i), loops.world()).value());
        loops.step(time + 0.1 * kTick, i == milliseconds / 3);
        loops.step(time + 0.6 * kTick, false);
    }
    return loops.recorded();
}

} // namespace

RecordedRun handMadeRun(int milliseconds) {
    const auto plates = {bumpyPlate(1), bumpyPlate(2)};
    return run(milliseconds, [&](int i) { return bumpyScene(plates.begin()[i / 100 % 2], i); });
}

RecordedRun handMadeRun(int milliseconds, const Scene& scene) {
    return run(milliseconds, [&](int) { return scene; });
}

void writeGrid(const std::filesystem::path& file, int n) {
    std::ofstream out(file);
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k)
            out << "v " << 0.1 * i / n - 0.05 << ' ' << 0.1 * k / n - 0.05 << " 0\n";
    const auto corner = [n](int i, int k) { return i * (n + 1) + k + 1; };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            out << "f " << corner(i, k) << ' ' << corner(i + 1, k) << ' ' << corner(i + 1, k + 1) << ' '
                << corner(i, k + 1) << '\n';
}

} // namespace tactum
