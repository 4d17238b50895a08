// A self-test in the window: the experiments on a thread of their own, and the person's answers from here.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <QObject>
#include <QString>

#include "core/port/haptic_device.h"
#include "core/self_test/device_bench.h"
#include "core/self_test/self_test.h"

namespace tactum {

/// In the language that is on, each part of it too. Thread: ui.
QString trialText(const TrialWords& words);

/// What the person is asked for.
struct TrialQuestion {
    enum class Kind { Does, Mass };
    Kind kind = Kind::Does;
    TrialAsk ask = TrialAsk::LetGo;
    TrialWords words;
    double heaviest = 0; ///< kg, of a mass
};

/// Makes the device ready, measures it and closes it. The device has no force but within an experiment.
/// Thread: ui.
class SelfTestRun : public QObject {
    Q_OBJECT
public:
    SelfTestRun(std::unique_ptr<HapticDevice> device, const SelfTestPace& pace, QObject* parent = nullptr);
    /// Ends it, and waits until the device is closed.
    ~SelfTestRun() override;

    void start();
    /// To asked(): it is done, or it is left out.
    void answer(bool done);
    /// kg, to asked() for a mass; nullopt: it is left out.
    void answerMass(std::optional<double> mass);
    /// No force from the device's next tick on; finished() follows. `why`: what failure() then says.
    void end(const QString& why = {});
    /// What the device says now; nullopt while it is not open.
    std::optional<TrialLook> look();
    const DeviceInfo& device() const { return info_; }
    bool finishedWhole() const { return report_.has_value(); }
    const SelfTestReport& report() const { return *report_; }
    /// Why there is no report; empty when the person ended it.
    const QString& failure() const { return failure_; }

signals:
    /// The device is being made ready; `request`: what the person does for that.
    void prepares(const QString& step, const QString& request);
    void begun(tactum::TrialPart part);
    void asked(const tactum::TrialQuestion& question);
    void told(const QString& words);
    /// The device is closed and gone.
    void finished();

private:
    class Person;
    void work();
    Result<SelfTestReport> measure(Person& person);
    std::optional<double> wait(const TrialQuestion& question);
    void reply(std::optional<double> answer);
    template <class Act> void later(Act act);

    std::unique_ptr<HapticDevice> device_; ///< of the worker once it runs
    DeviceInfo info_;
    SelfTestPace pace_;
    std::thread worker_;
    std::mutex mutex_; ///< of what follows
    std::condition_variable answered_;
    bool waits_ = false, ended_ = false;
    std::optional<double> answer_;
    DeviceBench* bench_ = nullptr; ///< while it is open
    // Of this thread again.
    std::optional<SelfTestReport> report_;
    QString failure_, why_;
};

} // namespace tactum
