// A device that the engine gives away for a while, and gets back.
#include <utility>

#include "ui/base/words.h"
#include "ui/engine/device_link.h"

namespace tactum {

QString DeviceLink::whyNotLend() const {
    if (!catalogue_) return tr("The device is the server's; measure it there.");
    if (preparing()) return whyWhilePreparing();
    if (!connected() || lost())
        return tr("No device is connected, and a simulated hand has nothing to be measured.");
    if (hands_.count() > 1) return tr("There are several hands; remove the others first.");
    if (!hands_.trouble(0).empty()) return QString::fromStdString(hands_.trouble(0));
    return {};
}

void DeviceLink::lend() {
    if (!whyNotLend().isEmpty()) return;
    lending_ = true;
    const std::string id = current().toStdString();
    const auto stop = std::make_shared<StopSwitch>();
    stop->buttons = used_[0].stop->buttons.load();
    park();
    pool_.start([this, id, stop] {
        auto made = [&] {
            const std::lock_guard alone(asking_);
            return catalogue_->make(id);
        }();
        const Made device =
            made ? std::make_shared<std::unique_ptr<HapticDevice>>(std::move(*made)) : nullptr;
        const QString failure = made ? QString() : QString::fromStdString(made.error().text);
        QMetaObject::invokeMethod(
            this,
            [this, device, stop, failure] {
                if (device) *device = std::make_unique<StopButton>(withOwnLimit(std::move(*device)), stop);
                emit lent(device, failure);
            },
            Qt::QueuedConnection);
    });
}

void DeviceLink::takeBack() {
    if (!std::exchange(lending_, false)) return;
    wantedThere_ = false;
    look();
}

void DeviceLink::keepFigures(const QString& name, const std::string& profile) {
    pool_.start([this, name = name.toStdString(), profile] {
        const auto kept = [&] {
            const std::lock_guard alone(asking_);
            return catalogue_->keepFigures(name, profile);
        }();
        QMetaObject::invokeMethod(
            this,
            [this, sentence = asIs(kept ? *kept : kept.error().text), done = kept.has_value()] {
                emit figuresKept(sentence, done);
            },
            Qt::QueuedConnection);
    });
}

} // namespace tactum
