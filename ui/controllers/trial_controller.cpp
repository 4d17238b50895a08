#include "ui/controllers/trial_controller.h"

#include "core/runtime/engine.h"
#include "core/scene/scene.h"
#include "ui/controllers/arming.h"
#include "ui/controllers/stage.h"
#include "ui/engine/device_settings.h"
#include "ui/engine/health_words.h"
#include "ui/engine/world_publisher.h"
#include "ui/panels/device_trial_page.h"
#include "ui/showing/playback.h"
#include "ui/tools/hand_link.h"

namespace tactum {

namespace {

constexpr std::pair<const char*, Trial> kTrials[] = {
    {"trial-spring", Trial::Spring}, {"trial-wall", Trial::Wall}, {"trial-friction", Trial::Friction}};

} // namespace

TrialController::TrialController(const Workbench& bench, Arming& arming, Stage& stage, HandLink& hand,
                                 DeviceTrialPage& page)
    : QObject(&bench.window), bench_(bench), arming_(arming), stage_(stage), hand_(hand), page_(page) {
    for (const auto& [id, trial] : kTrials)
        bench.on(id, this, [this, trial = trial] {
            emit asked();
            begin(trial);
        });
    bench.on("trial-end", this, [this] { end(); });
    connect(&page, &DeviceTrialPage::chosen, this, &TrialController::begin);
    connect(&page, &DeviceTrialPage::endPressed, this, &TrialController::end);
    show();
}

void TrialController::begin(Trial trial) {
    bench_.playback.end();
    arming_.switchOff();
    const ServoTelemetry& servo = bench_.engine.servo();
    const DeviceInfo& device = bench_.engine.device();
    const TrialFigures figures{.centre = servo.frame.offset,
                               .radius = servo.frame.scale * usualRadius(device),
                               .maxForce = device.maxForce,
                               .ceiling =
                                   ceilingNow(servo, device).value}; // not the one that is shown, which waits
    trial_ = trial;
    const auto scene = std::make_shared<const Scene>(trialScene(trial, figures));
    bench_.publisher.setTrial(scene);
    stage_.showOther(*scene);
    hand_.placeAt(figures.centre);
    show();
}

void TrialController::end() {
    if (!trial_) return;
    trial_.reset();
    arming_.switchOff();
    bench_.publisher.setTrial(nullptr);
    stage_.showOwn();
    hand_.placeBeside();
    show();
}

void TrialController::show() {
    for (const auto& [id, trial] : kTrials)
        bench_.actions[id].setChecked(trial_ == trial);
    bench_.actions["trial-end"].setEnabled(trial_.has_value());
    page_.setTrial(trial_);
}

} // namespace tactum
