// The hands beside the first: added, removed, lost, remembered and brought back.
#include <algorithm>
#include <utility>

#include <QSettings>

#include "ui/engine/device_link.h"

namespace tactum {

namespace {

QString besideKey() {
    return QStringLiteral("device/beside");
}

} // namespace

QString DeviceLink::whyNotAdd(const QString& id) const {
    if (id.isEmpty() || !catalogue_) return tr("No device is chosen.");
    if (preparing()) return whyWhilePreparing();
    if (uses(id)) return tr("A hand has this device already.");
    if (!hands_.mayAdd()) return tr("There are as many hands as can be; remove one first.");
    if (id == kSimulatedDevice && !connected())
        return tr("The mouse leads one hand alone; connect a device first.");
    return id == kSimulatedDevice && !spare_ ? tr("The simulated hand is not there yet.") : QString();
}

QString DeviceLink::whyWhilePreparing() {
    return tr("A device is being made ready; wait for it, or give it up.");
}

void DeviceLink::add(const QString& id) {
    if (!mayAdd(id)) return;
    if (id != kSimulatedDevice) return begin(std::make_shared<Attempt>(id, false, true));
    const Made spare = std::exchange(spare_, nullptr);
    if (const Result<void> added = adoptBeside(id, std::move(*spare)); !added)
        emit failed(QString::fromStdString(added.error().text));
    look();
}

void DeviceLink::remove(std::size_t hand) {
    forget(idOf(hand));
    drop(hand);
}

void DeviceLink::drop(std::size_t hand) {
    emit letsGo();
    takeOut(hand);
    emit exchanged();
}

void DeviceLink::takeOut(std::size_t hand) {
    used_.erase(used_.begin() + std::ptrdiff_t(hand));
    if (const Result<void> removed = hands_.remove(hand); !removed)
        emit failed(QString::fromStdString(removed.error().text));
}

std::optional<std::size_t> DeviceLink::besideInTrouble(const QString& id) const {
    for (std::size_t hand = 1; hand < used_.size(); ++hand)
        if (used_[hand].id == id && !hands_.trouble(hand).empty()) return hand;
    return std::nullopt;
}

void DeviceLink::letGoOfLost() {
    for (std::size_t hand = used_.size(); hand-- > 1;)
        if (used_[hand].gone) drop(hand);
    if (used_[0].gone) park();
}

/// One that does not start leaves the others as they were.
Result<void> DeviceLink::adoptBeside(const QString& id, std::unique_ptr<HapticDevice> device) {
    emit letsGo();
    Used used{.id = id};
    const std::size_t before = hands_.count();
    const Result<void> added =
        hands_.add(std::make_unique<StopButton>(withOwnLimit(std::move(device)), used.stop)).and_then([this] {
            return engine_.start();
        });
    if (added) {
        used_.push_back(std::move(used));
        remember(id, QString::fromStdString(hands_.device(before).name));
    } else if (hands_.count() > before) {
        (void)hands_.remove(before);
        (void)engine_.start(); // which says by running() that it could not
    }
    emit exchanged();
    return added;
}

/// No device loses a force for it that a person switched on.
bool DeviceLink::mayBringBack() const {
    for (std::size_t hand = 0; hand < used_.size(); ++hand)
        if (leadsItself(hand) && hands_.armed(hand)) return false;
    return true;
}

/// It is made ready, and a person has force.
void DeviceLink::wait(const Made& device) {
    waiting_ = device;
    preparation_.request = tr("It is ready, and becomes a hand when the forces are off.");
    emit preparationChanged();
}

/// One after the other, and each once for each time that it appears.
void DeviceLink::bringBackBeside() {
    if (lending_) return;
    for (Remembered& hand : beside_) {
        const DeviceListing* listing = find(hand.id);
        if (!listing || !listing->usable) hand.tried = false;
        if (!listing || !listing->usable || hand.tried || attempt_ || !mayAdd(hand.id)) continue;
        if (hand.id != kSimulatedDevice) {
            hand.tried = true;
            return begin(std::make_shared<Attempt>(hand.id, true, true));
        }
        if (mayBringBack()) return add(hand.id);
    }
}

void DeviceLink::recall() {
    QSettings settings;
    const int count = settings.beginReadArray(besideKey());
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        const QString id = settings.value(QStringLiteral("id")).toString();
        if (!id.isEmpty() && id != wanted_)
            beside_.push_back({id, settings.value(QStringLiteral("name"), id).toString()});
    }
}

void DeviceLink::remember(const QString& id, const QString& name) {
    if (std::ranges::find(beside_, id, &Remembered::id) != beside_.end()) return;
    beside_.push_back({id, name});
    keep();
}

void DeviceLink::forget(const QString& id) {
    if (std::erase_if(beside_, [&](const Remembered& hand) { return hand.id == id; }) > 0) keep();
}

void DeviceLink::keep() const {
    QSettings settings;
    settings.remove(besideKey());
    settings.beginWriteArray(besideKey(), int(beside_.size()));
    for (std::size_t i = 0; i < beside_.size(); ++i) {
        settings.setArrayIndex(int(i));
        settings.setValue(QStringLiteral("id"), beside_[i].id);
        settings.setValue(QStringLiteral("name"), beside_[i].name);
    }
}

} // namespace tactum
