#include "ui/engine/self_test_run.h"

#include <utility>

#include "core/port/device_check.h"
#include "ui/base/words.h"

namespace tactum {

QString trialText(const TrialWords& words) {
    QString text = wordsOf(std::string_view(words.form));
    for (std::size_t i = words.parts.size(); i-- > 0;)
        text.replace(QStringLiteral("%%1").arg(i + 1), trialText(words.parts[i]));
    return text;
}

/// Passes on from the worker what is asked and told, and waits for the person.
class SelfTestRun::Person final : public TrialPerson, public Opening {
public:
    explicit Person(SelfTestRun& run) : run_(run) {}

    void begins(TrialPart part) override {
        run_.later([&run = run_, part] { emit run.begun(part); });
    }
    bool does(TrialAsk what, const TrialWords& words) override {
        return run_.wait({.ask = what, .words = words}).has_value();
    }
    std::optional<double> mass(double heaviest) override {
        return run_.wait({.kind = TrialQuestion::Kind::Mass, .words = {}, .heaviest = heaviest});
    }
    void hears(const TrialWords& words) override {
        run_.later([&run = run_, words] { emit run.told(trialText(words)); });
    }
    bool leaves() const override {
        const std::lock_guard lock(run_.mutex_);
        return run_.ended_;
    }
    void begin(std::string_view step, std::string_view request) override {
        run_.later(
            [&run = run_, step = asIs(step), request = asIs(request)] { emit run.prepares(step, request); });
    }
    void progress(double) override {}
    bool cancelled() const override { return leaves(); }

private:
    SelfTestRun& run_;
};

SelfTestRun::SelfTestRun(std::unique_ptr<HapticDevice> device, const SelfTestPace& pace, QObject* parent)
    : QObject(parent), device_(std::move(device)), info_(device_->info()), pace_(pace) {}

// What the worker still sends finds nobody any more: Qt drops it with this object.
SelfTestRun::~SelfTestRun() {
    end();
    if (worker_.joinable()) worker_.join();
}

void SelfTestRun::start() {
    worker_ = std::thread([this] { work(); });
}

template <class Act> void SelfTestRun::later(Act act) {
    QMetaObject::invokeMethod(this, std::move(act), Qt::QueuedConnection);
}

/// Thread: the worker.
void SelfTestRun::work() {
    Person person(*this);
    auto report = device_->prepare(person)
                      .and_then([this] { return device_->open(); })
                      .and_then([&]() -> Result<SelfTestReport> {
                          auto measured = measure(person);
                          device_->close();
                          return measured;
                      });
    device_.reset();
    later([this, report = std::move(report)]() mutable {
        if (report && !ended_)
            report_ = std::move(*report);
        else
            failure_ = ended_ ? why_ : QString::fromStdString(report.error().text);
        emit finished();
    });
}

Result<SelfTestReport> SelfTestRun::measure(Person& person) {
    const DeviceInfo info = device_->info(); // now it knows itself
    if (const auto sound = checkDevice(info); !sound) return tl::unexpected<Error>(sound.error());
    DeviceBench bench(*device_);
    if (const auto started = bench.start(); !started) return tl::unexpected<Error>(started.error());
    const auto show = [this](DeviceBench* shown) {
        const std::lock_guard lock(mutex_);
        bench_ = shown;
        if (shown && ended_) shown->end();
    };
    show(&bench);
    later([this, info] { info_ = info; });
    auto report = selfTest(bench, person, info, pace_);
    show(nullptr);
    return report;
}

/// The answer; nullopt: it is left out, or all of it was ended.
std::optional<double> SelfTestRun::wait(const TrialQuestion& question) {
    std::unique_lock lock(mutex_);
    if (ended_) return std::nullopt;
    waits_ = true;
    later([this, question] { emit asked(question); });
    answered_.wait(lock, [this] { return !waits_ || ended_; });
    waits_ = false;
    return ended_ ? std::nullopt : answer_;
}

void SelfTestRun::reply(std::optional<double> answer) {
    const std::lock_guard lock(mutex_);
    if (!waits_) return;
    answer_ = answer;
    waits_ = false;
    answered_.notify_all();
}

void SelfTestRun::answer(bool done) {
    reply(done ? std::optional(0.0) : std::nullopt);
}

void SelfTestRun::answerMass(std::optional<double> mass) {
    reply(mass);
}

void SelfTestRun::end(const QString& why) {
    const std::lock_guard lock(mutex_);
    if (ended_) return;
    why_ = why;
    ended_ = true;
    if (bench_) bench_->end();
    answered_.notify_all();
}

std::optional<TrialLook> SelfTestRun::look() {
    const std::lock_guard lock(mutex_);
    if (!bench_) return std::nullopt;
    return bench_->look();
}

} // namespace tactum
