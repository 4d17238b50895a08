#include "ui/engine/device_link.h"
#include <algorithm>
#include <cmath>
#include <utility>

#include <QSettings>

#include "core/port/own_limit.h"
#include "ui/base/preferences.h"
#include "ui/base/words.h"
#include "ui/engine/hand_name.h"

namespace tactum {

namespace {

constexpr int kLook = 1000; // ms

QString chosenKey() {
    return QStringLiteral("device/chosen");
}

/// What that is called, for when it is not there.
QString nameKey() {
    return QStringLiteral("device/chosen-name");
}

} // namespace

std::unique_ptr<HapticDevice> withOwnLimit(std::unique_ptr<HapticDevice> device) {
    const double limit = Preferences::instance().value(Preferred::LargestForce);
    if (limit <= 0) return device;
    return std::make_unique<OwnLimit>(std::move(device), limit);
}

/// Passes on from the worker what the device says while it is made ready.
class DeviceLink::Watch final : public Opening {
public:
    Watch(DeviceLink& link, std::shared_ptr<Attempt> attempt) : link_(link), attempt_(std::move(attempt)) {}

    void begin(std::string_view step, std::string_view request) override {
        shown_ = 0;
        tell([&link = link_, step = asIs(step), request = asIs(request)] { link.beginStep(step, request); });
    }
    /// In order with the steps, so that no step is shown with the progress of the next.
    void progress(double part) override {
        const double shown = std::round(kShownParts * std::clamp(part, 0.0, 1.0)) / kShownParts;
        if (std::exchange(shown_, shown) == shown) return;
        tell([&link = link_, shown] { link.goOn(shown); });
    }
    bool cancelled() const override { return attempt_->cancelled; }

private:
    static constexpr double kShownParts = 1000; ///< a device may tell its progress with each reading

    /// What comes after the attempt ended is dropped.
    template <class Said> void tell(Said said) {
        QMetaObject::invokeMethod(
            &link_,
            [&link = link_, attempt = attempt_, said = std::move(said)] {
                if (attempt == link.attempt_) said();
            },
            Qt::QueuedConnection);
    }

    DeviceLink& link_;
    std::shared_ptr<Attempt> attempt_;
    double shown_ = 0;
};

DeviceLink::DeviceLink(Engine& engine, QObject* parent) : QObject(parent), engine_(engine), hands_(engine) {
    for (std::size_t hand = 0; hand < hands_.count(); ++hand)
        used_.push_back({.id = givenId(hand)});
    wanted_ = current();
    pool_.setMaxThreadCount(2);
    timer_.setSingleShot(true);
    timer_.setInterval(kLook);
    connect(&timer_, &QTimer::timeout, this, &DeviceLink::look);
}

// What the workers still send finds nobody any more: Qt drops it with this object, the device with it.
DeviceLink::~DeviceLink() {
    if (attempt_) attempt_->cancelled = true;
    pool_.waitForDone();
}

void DeviceLink::setCatalogue(DeviceCatalogue& catalogue) {
    catalogue_ = &catalogue;
    wanted_ = QSettings().value(chosenKey(), current()).toString();
    recall();
    look();
}

const DeviceListing* DeviceLink::find(const QString& id) const {
    if (id.isEmpty()) return nullptr;
    const auto found = std::ranges::find(devices_, id.toStdString(), &DeviceListing::id);
    return found == devices_.end() ? nullptr : &*found;
}

void DeviceLink::look() {
    if (!catalogue_) return;
    again_ = listing_;
    if (listing_) return;
    listing_ = true;
    timer_.stop();
    pool_.start([this, wantsSpare = !spare_] {
        const std::lock_guard alone(asking_);
        auto found = catalogue_->list();
        Made spare;
        if (wantsSpare)
            if (auto made = catalogue_->make(kSimulatedDevice.toStdString()))
                spare = std::make_shared<std::unique_ptr<HapticDevice>>(std::move(*made));
        QMetaObject::invokeMethod(
            this, [this, found = std::move(found), spare] { listed(found, spare); }, Qt::QueuedConnection);
    });
}

void DeviceLink::listed(std::vector<DeviceListing> found, const Made& spare) {
    listing_ = false;
    if (spare) spare_ = spare;
    std::size_t troubled = 0;
    for (std::size_t hand = 0; hand < hands_.count(); ++hand)
        troubled += !hands_.trouble(hand).empty();
    const bool changed = found != devices_ || spare || troubled != troubled_;
    troubled_ = troubled;
    devices_ = std::move(found);
    for (std::size_t hand = used_.size(); hand-- > 0;)
        if (isLost(hand)) lose(hand);
    for (std::size_t hand = 0; hand < used_.size(); ++hand)
        used_[hand].seenUnread = hands_.servo(hand).invalidSamples;
    bringBack();
    bringBackBeside();
    sayMissing();
    if (changed) emit listChanged();
    if (std::exchange(again_, false)) return look();
    timer_.start();
}

// A device that is open may be hidden from a list, by its maker's library for instance: it is lost when its
// readings do not come either, or its driver does not come back at all.
bool DeviceLink::unread(std::size_t hand) {
    constexpr std::uint64_t kHiccup = 100; // readings
    const ServoTelemetry& servo = hands_.servo(hand);
    return !engine_.running() || hands_.servoStandsStill(hand) ||
           servo.inhibit == InhibitReason::DeviceLost ||
           servo.invalidSamples > used_[hand].seenUnread + kHiccup;
}

bool DeviceLink::isLost(std::size_t hand) {
    const Used& used = used_[hand];
    return leadsItself(hand) && !used.id.isEmpty() && !used.gone && !find(used.id) && unread(hand);
}

void DeviceLink::lose(std::size_t hand) {
    const QString name = handName(hands_, hand);
    used_[hand].gone = true;
    if (hand == 0) {
        lostName_ = name;
        wantedThere_ = false;
    }
    hands_.setArmed(hand, false);
    const bool others = hands_.anyArmed();
    if (!others) letGoOfLost();
    if (hand == 0)
        emit wentAway(name, others);
    else
        emit besideWentAway(name, others);
}

/// Once for each time that the wanted device appears: what failed is not tried without end.
void DeviceLink::bringBack() {
    if (lending_) return;
    const DeviceListing* wanted = find(wanted_);
    const bool there = wanted && wanted->usable;
    if (there && attempt_) return; // another one first
    if (there && !wantedThere_ && !uses(wanted_)) begin(std::make_shared<Attempt>(wanted_, true));
    wantedThere_ = there;
}

/// Once, of what the last start had and this one has not.
void DeviceLink::sayMissing() {
    if (std::exchange(looked_, true)) return;
    QStringList names;
    if (wanted_ != kSimulatedDevice && !uses(wanted_) && !find(wanted_))
        names << QSettings().value(nameKey(), wanted_).toString();
    for (const Remembered& hand : beside_)
        if (hand.id != kSimulatedDevice && !find(hand.id)) names << hand.name;
    if (!names.isEmpty()) emit missing(names);
}

std::optional<std::size_t> DeviceLink::simulatedHand() const {
    const auto found = std::ranges::find(used_, kSimulatedDevice, &Used::id);
    if (found == used_.end()) return std::nullopt;
    return std::size_t(found - used_.begin());
}

bool DeviceLink::uses(const QString& id) const {
    return std::ranges::find(used_, id, &Used::id) != used_.end();
}

// By value: it may be the name of the current device, which changes on the way.
void DeviceLink::choose(QString id) {
    if (!catalogue_ || id.isEmpty()) return;
    if (const auto hand = besideInTrouble(id)) {
        drop(*hand);
        return add(id);
    }
    if (id != kSimulatedDevice && id != current() && uses(id)) return; // another hand has it
    wanted_ = id;
    QSettings().setValue(chosenKey(), id);
    forget(id);
    const DeviceListing* listing = find(id);
    wantedThere_ = listing && listing->usable;
    if (id != kSimulatedDevice) {
        if (mayBegin(id) || id != current()) begin(std::make_shared<Attempt>(id));
        return;
    }
    giveUp();
    next_.reset();
    lostName_.clear();
    if (!attempt_) finish(Preparation::State::None);
    if (connected() || !engine_.running()) park();
}

QString DeviceLink::whyNotBegin(const QString& id) const {
    if (id.isEmpty()) return tr("No device is chosen.");
    if (preparing()) return whyWhilePreparing();
    if (id == current())
        return connected() && !hands_.trouble(0).empty() ? QString() : tr("This device is in use already.");
    const bool free = !uses(id) || id == kSimulatedDevice || besideInTrouble(id);
    return free ? QString() : tr("Another hand has this device; remove that hand first.");
}

QString DeviceLink::whyNotLetGo() const {
    const bool any = catalogue_ && (connected() || preparing() || wanted_ != kSimulatedDevice);
    return any ? QString() : tr("No device is connected.");
}

void DeviceLink::tryAgain() {
    if (preparing() || preparation_.id.isEmpty()) return;
    if (preparation_.beside)
        add(preparation_.id);
    else
        choose(preparation_.id);
}

void DeviceLink::supply(const QString& id, const QString& file) {
    pool_.start([this, id, file] {
        const auto kept = [&] {
            const std::lock_guard alone(asking_);
            return catalogue_->supply(id.toStdString(), file.toStdString());
        }();
        QMetaObject::invokeMethod(
            this,
            [this, id, kept] {
                if (!kept) return emit failed(QString::fromStdString(kept.error().text));
                emit supplied(QString::fromStdString(*kept));
                look();
                if (preparation_.state == Preparation::State::Failed && preparation_.id == id) tryAgain();
            },
            Qt::QueuedConnection);
    });
}

void DeviceLink::giveUp() {
    if (!attempt_) return;
    attempt_->cancelled = true;
    next_.reset();
    preparation_.givingUp = true;
    emit preparationChanged();
}

void DeviceLink::begin(const std::shared_ptr<Attempt>& attempt) {
    if (attempt_) {
        attempt_->cancelled = true;
        next_ = attempt;
        return;
    }
    // Nothing pushes while the person is busy with another device, and the same one is free to be opened.
    if (connected() && !attempt->beside) park();
    const DeviceListing* listing = find(attempt->id);
    preparation_ = {.state = Preparation::State::Running,
                    .beside = attempt->beside,
                    .id = attempt->id,
                    .name = listing ? QString::fromStdString(listing->name) : attempt->id,
                    .steps = {},
                    .request = {},
                    .progress = 0,
                    .givingUp = false,
                    .failure = {}};
    attempt_ = attempt;
    pool_.start([this, attempt] { prepare(attempt); });
    emit preparationChanged();
}

/// Thread: a worker.
void DeviceLink::prepare(const std::shared_ptr<Attempt>& attempt) {
    const auto deliver = [this, attempt](const Made& device, const QString& failure) {
        QMetaObject::invokeMethod(
            this, [this, attempt, device, failure] { ended(attempt, device, failure); },
            Qt::QueuedConnection);
    };
    auto made = [&] {
        const std::lock_guard alone(asking_);
        return catalogue_->make(attempt->id.toStdString());
    }();
    if (!made) return deliver({}, QString::fromStdString(made.error().text));
    auto device = std::make_shared<std::unique_ptr<HapticDevice>>(std::move(*made));
    QMetaObject::invokeMethod(
        this,
        [this, attempt, name = QString::fromStdString((*device)->info().name), steps = (*device)->steps()] {
            if (attempt == attempt_) knowSteps(name, steps);
        },
        Qt::QueuedConnection);
    Watch watch(*this, attempt);
    const Result<void> prepared = (*device)->prepare(watch);
    if (prepared && !attempt->cancelled) return deliver(device, {});
    device.reset(); // here: it may take its time
    deliver({}, prepared ? QString() : QString::fromStdString(prepared.error().text));
}

void DeviceLink::knowSteps(const QString& name, const std::vector<std::string>& steps) {
    if (!name.isEmpty()) preparation_.name = name;
    for (const std::string& step : steps)
        preparation_.steps.push_back({QString::fromStdString(step), StepState::Waiting});
    emit preparationChanged();
}

/// A step that was not announced is shown all the same.
void DeviceLink::beginStep(const QString& step, const QString& request) {
    auto& steps = preparation_.steps;
    auto at = std::ranges::find(steps, step, &Preparation::Step::name);
    if (at == steps.end()) at = steps.insert(steps.end(), {step, StepState::Waiting});
    for (auto before = steps.begin(); before != at; ++before)
        before->state = StepState::Done;
    at->state = StepState::Doing;
    preparation_.request = request;
    preparation_.progress = 0;
    emit preparationChanged();
}

void DeviceLink::goOn(double part) {
    preparation_.progress = part;
    emit preparationChanged();
}

/// Of a device that somebody else put into the engine.
QString DeviceLink::givenId(std::size_t hand) const {
    return hands_.device(hand).real ? QString() : kSimulatedDevice;
}

void DeviceLink::follow() {
    if (catalogue_) return;
    bool other = used_.size() != hands_.count();
    used_.resize(hands_.count());
    for (std::size_t hand = 0; hand < used_.size(); ++hand) {
        const QString before = std::exchange(used_[hand].id, givenId(hand));
        other = other || before != used_[hand].id;
    }
    if (other) emit handsFollowed();
}

void DeviceLink::frame() {
    if (std::ranges::any_of(used_, &Used::gone) && !hands_.anyArmed()) letGoOfLost();
    if (waiting_ && (attempt_->cancelled || mayBringBack()))
        ended(std::shared_ptr(attempt_), std::exchange(waiting_, nullptr), {});
}

void DeviceLink::ended(const std::shared_ptr<Attempt>& attempt, const Made& device, const QString& failure) {
    if (device && attempt->back && !attempt->cancelled && !mayBringBack()) return wait(device);
    attempt_.reset();
    // The person may want another one by now.
    if (attempt->cancelled || (attempt->id != wanted_ && !attempt->beside))
        finish(wanted_ == kSimulatedDevice ? Preparation::State::None : Preparation::State::GivenUp);
    else if (device)
        adopt(*attempt, std::move(*device));
    else
        fail(failure);
    if (next_ && !attempt_) begin(std::exchange(next_, nullptr));
}

void DeviceLink::adopt(const Attempt& attempt, std::unique_ptr<HapticDevice> device) {
    if (attempt.beside) {
        if (const Result<void> added = adoptBeside(attempt.id, std::move(device)); !added)
            return fail(QString::fromStdString(added.error().text));
    } else {
        emit letsGo();
        Used used{.id = attempt.id};
        const Result<void> started =
            hands_.exchange(0, std::make_unique<StopButton>(withOwnLimit(std::move(device)), used.stop));
        if (!started) {
            park();
            return fail(QString::fromStdString(started.error().text));
        }
        used_[0] = std::move(used);
        lostName_.clear();
        QSettings().setValue(nameKey(), QString::fromStdString(hands_.device(0).name));
    }
    for (Preparation::Step& step : preparation_.steps)
        step.state = StepState::Done;
    // Which it knows only now.
    preparation_.name = QString::fromStdString(hands_.device(attempt.beside ? hands_.count() - 1 : 0).name);
    finish(Preparation::State::Done);
    if (!attempt.beside) emit exchanged();
    emit ready(preparation_.name, attempt.back);
}

void DeviceLink::fail(const QString& sentence) {
    QString where = preparation_.name;
    for (Preparation::Step& step : preparation_.steps)
        if (step.state == StepState::Doing) {
            step.state = StepState::Failed;
            where = tr("%1, step \"%2\"").arg(preparation_.name, step.name);
            if (sentence.contains(step.name)) where = preparation_.name; // it says so itself
        }
    preparation_.failure = sentence;
    finish(Preparation::State::Failed);
    emit failed(QStringLiteral("%1: %2").arg(where, sentence));
}

void DeviceLink::finish(Preparation::State state) {
    preparation_.state = state;
    preparation_.request.clear();
    preparation_.givingUp = false;
    for (Preparation::Step& step : preparation_.steps)
        if (step.state == StepState::Doing) step.state = StepState::Waiting;
    emit preparationChanged();
}

/// The simulated device into the engine, and a look for the next spare one. Where the catalogue has none, the
/// loops rest.
void DeviceLink::park() {
    emit letsGo();
    if (const auto simulated = simulatedHand(); simulated && *simulated > 0)
        takeOut(*simulated); // the mouse leads one hand
    used_[0] = {.id = kSimulatedDevice};
    const Result<void> stopped = engine_.stop();
    if (const Made spare = std::exchange(spare_, nullptr))
        (void)hands_.exchange(0, withOwnLimit(std::move(*spare))); // it opens nothing that could fail
    look();
    emit exchanged();
    if (!stopped) emit failed(QString::fromStdString(stopped.error().text));
}

} // namespace tactum
