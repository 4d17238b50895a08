// Devices in the window: the dock, what happens when one comes or goes, its workspace, scenes to try it with.
#include <QAction>
#include <QDockWidget>
#include <QStackedWidget>

#include <cmath>
#include <limits>

#include "ui/engine/device_link.h"
#include "ui/engine/guard_watch.h"
#include "ui/engine/health_words.h"
#include "ui/engine/usb_permission.h"
#include "ui/panels/device_connect.h"
#include "ui/panels/device_live.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/device_trial_page.h"
#include "ui/panels/workspace_fields.h"
#include "ui/showing/playback.h"
#include "ui/tools/hand_link.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/window/folds.h"
#include "ui/window/main_window.h"

namespace tactum {

namespace {

constexpr double kUsualRadius = 0.05; // m, of a workspace that is not known
constexpr std::pair<const char*, Trial> kTrials[] = {
    {"trial-spring", Trial::Spring}, {"trial-wall", Trial::Wall}, {"trial-friction", Trial::Friction}};

double radiusOf(const DeviceInfo& device) {
    return device.workspaceRadius > 0 ? device.workspaceRadius : kUsualRadius;
}

} // namespace

void MainWindow::setCatalogue(DeviceCatalogue& catalogue) {
    link_->setCatalogue(catalogue);
    showDeviceCommands();
}

void MainWindow::addDeviceDock() {
    devicePanel_ = new DevicePanel(*link_);
    const auto dock = [this](const char* name) { return findChild<QDockWidget*>(QString::fromLatin1(name)); };
    addTabBeside(*this, *dock("dock-inspector"), QStringLiteral("dock-device"), tr("Device"), devicePanel_);
    dock("dock-inspector")->raise();
}

void MainWindow::connectDevices() {
    const auto on = [this](const char* id, auto act) {
        connect(&actions_[id], &QAction::triggered, this, act);
    };
    const auto choose = [this] { link_->choose(devicePanel_->connecting().chosen()); };
    const auto release = [this] { link_->choose(kSimulatedDevice); };
    on("device-panel", [this] { showDevicePage(int(DevicePanel::Page::Connect)); });
    on("device-connect", choose);
    on("device-disconnect", release);
    on("workspace-centre", [this] { centreWorkspace(false); });
    on("workspace-fit", [this] { centreWorkspace(true); });
    on("workspace-axes", [this] {
        showDevicePage(int(DevicePanel::Page::Workspace));
        devicePanel_->workspace().beginCapture();
    });
    for (const auto& [id, trial] : kTrials)
        on(id, [this, trial = trial] {
            showDevicePage(int(DevicePanel::Page::Trial));
            beginTrial(trial);
        });
    on("trial-end", [this] { endTrial(); });
    connect(link_, &DeviceLink::exchanged, this, &MainWindow::adoptDevice);
    connect(link_, &DeviceLink::ready, this, &MainWindow::offerReady);
    connect(link_, &DeviceLink::failed, notice_, &NoticeBar::showError);
    connect(link_, &DeviceLink::supplied, notice_, &NoticeBar::showNote);
    connect(link_, &DeviceLink::wentAway, this, [this](const QString& name) { sayAway(name); });
    connect(link_, &DeviceLink::preparationChanged, this, &MainWindow::showDeviceCommands);
    connect(link_, &DeviceLink::preparationChanged, this, &MainWindow::sayRequest);
    connect(devicePanel_, &DevicePanel::armPressed, this, &MainWindow::setArmed);
    DeviceConnect& connecting = devicePanel_->connecting();
    connect(&connecting, &DeviceConnect::connectPressed, this, choose);
    connect(&connecting, &DeviceConnect::disconnectPressed, this, release);
    connect(&connecting, &DeviceConnect::chosenChanged, this, &MainWindow::showDeviceCommands);
    connect(&connecting, &DeviceConnect::permissionPressed, permission_, &UsbPermission::ask);
    connecting.setLacksRealTime(lacksRealTime());
    connect(permission_, &UsbPermission::refused, &connecting, &DeviceConnect::showCommand);
    connect(permission_, &UsbPermission::granted, this, [this] {
        notice_->showNote(
            tr("You may use USB devices now, and real time when you have logged in again. If yours is still "
               "not usable, plug it in anew."));
        devicePanel_->connecting().setLacksRealTime(lacksRealTime());
        link_->look();
    });
    connect(&devicePanel_->live(), &DeviceLive::stopButtonChosen, this, [this](std::uint32_t button) {
        DeviceSettings next = deviceSettings_;
        next.stopButton = button;
        next.workspace.clutch &= ~button; // a button does one thing
        setDeviceSettings(next);
    });
    connect(&devicePanel_->live(), &DeviceLive::graspChosen, this, [this](bool grasped) {
        DeviceSettings next = deviceSettings_;
        next.grasped = grasped;
        setDeviceSettings(next);
    });
    WorkspaceFields& workspace = devicePanel_->workspace();
    connect(&workspace, &WorkspaceFields::edited, this, &MainWindow::setWorkspace);
    connect(&workspace, &WorkspaceFields::centrePressed, this, [this] { centreWorkspace(false); });
    connect(&workspace, &WorkspaceFields::fitPressed, this, [this] { centreWorkspace(true); });
    connect(&workspace, &WorkspaceFields::captureBegun, this, &MainWindow::switchOff);
    connect(&devicePanel_->trial(), &DeviceTrialPage::chosen, this, &MainWindow::beginTrial);
    connect(&devicePanel_->trial(), &DeviceTrialPage::endPressed, this, &MainWindow::endTrial);
    hand_->setIdle(link_->connected());
    showDeviceSettings();
    showDeviceCommands();
}

void MainWindow::showDevicePage(int page) {
    folds_->bringForward(*findChild<QDockWidget*>(QStringLiteral("dock-device")));
    devicePanel_->showPage(DevicePanel::Page(page));
    devicePanel_->setFocus(Qt::ShortcutFocusReason);
}

/// Another device is in the engine, without force.
void MainWindow::adoptDevice() {
    endTrial(); // it was laid out for the other one
    withdrawArming();
    guard_->forget();
    showArmed(false);
    hand_->setIdle(link_->connected());
    if (link_->connected()) hint_->hide(); // the mouse leads nothing
    riskAccepted_ = false;
    deviceSettings_ = link_->connected() ? rememberedSettings(link_->current()) : DeviceSettings{};
    setDeviceSettings(deviceSettings_);
    restoreDeadMan();
    displayHealth();
    showDeviceCommands();
}

// How a person's device lies in the scene, and what its buttons do, belongs to neither the scene nor its
// history: the same scene is felt with other devices, and undoing an edit must not move somebody's hand.
void MainWindow::setDeviceSettings(const DeviceSettings& settings) {
    deviceSettings_ = settings;
    if (const auto possible = engine_.setWorkspace(settings.workspace); !possible)
        notice_->showError(QString::fromStdString(possible.error().text));
    link_->stop().buttons = settings.stopButton;
    engine_.setGrasped(settings.grasped);
    if (link_->connected()) rememberSettings(link_->current(), settings);
    showDeviceSettings();
}

void MainWindow::showDeviceSettings() {
    const DeviceInfo& device = engine_.device();
    devicePanel_->live().setGrasped(deviceSettings_.grasped, link_->connected());
    devicePanel_->live().setStopButton(deviceSettings_.stopButton, device.buttons, link_->connected());
    devicePanel_->workspace().show(deviceSettings_.workspace, device.buttons, device.workspaceRadius,
                                   link_->connected());
}

void MainWindow::setWorkspace(const Workspace& workspace) {
    DeviceSettings next = deviceSettings_;
    next.workspace = workspace;
    next.stopButton &= ~workspace.clutch; // a button does one thing
    setDeviceSettings(next);
}

void MainWindow::centreWorkspace(bool fit) {
    if (!link_->connected()) return;
    const Bounds model = boundsOf(document_.scene());
    Workspace next = deviceSettings_.workspace;
    next.offset = model.empty() ? Vec3(Vec3::Zero()) : model.centre();
    if (fit && model.diagonal() > 0)
        next.scale = kWorkspaceScale.clamped(0.5 * model.diagonal() / radiusOf(engine_.device()));
    ++next.centring;
    setWorkspace(next);
}

/// Once a frame.
void MainWindow::watchDevice() {
    link_->frame();
    devicePanel_->display(engine_);
    // The device itself has been without force since the tick that read the button.
    if (!link_->stop().pressed || !engine_.armed()) return;
    setArmed(false);
    notice_->showNote(tr("Stopped by the button of the device. Device > Forces on goes on."));
}

void MainWindow::offerReady(const QString& name, bool back) {
    notice_->offer((back ? tr("%1 is there and ready. The forces are off: hold the handle, then arm.")
                         : tr("%1 is ready. The forces are off: hold the handle, then arm."))
                       .arg(name),
                   QStringLiteral("note"), tr("Arm"), [this] { setArmed(true); });
}

/// A device that was remembered is made ready by itself, and waits for a person who may look elsewhere.
void MainWindow::sayRequest() {
    const Preparation& preparation = link_->preparation();
    if (preparation.request.isEmpty()) return notice_->withdraw(tr("Show"));
    const QString text = QStringLiteral("%1: %2").arg(preparation.name, preparation.request);
    if (!devicePanel_->visibleRegion().isEmpty() || notice_->text() == text) return;
    notice_->offer(text, QStringLiteral("note"), tr("Show"),
                   [this] { showDevicePage(int(DevicePanel::Page::Connect)); });
}

void MainWindow::sayAway(const QString& name, const QString& more) {
    notice_->showError(
        tr("%1 is not there any more; the forces are off. Plug it in: it is made ready again by "
           "itself. Until then the mouse leads a simulated hand. %2")
            .arg(name, more)
            .trimmed());
}

void MainWindow::showDeviceCommands() {
    const bool connected = link_->connected();
    actions_["device-connect"].setEnabled(link_->mayBegin(devicePanel_->connecting().chosen()));
    actions_["device-disconnect"].setEnabled(link_->mayLetGo());
    for (const char* id : {"workspace-centre", "workspace-fit", "workspace-axes"})
        actions_[id].setEnabled(connected && !playback_->active());
    showTrial();
}

void MainWindow::switchOff() {
    guard_->setArmed(false);
    showArmed(false);
}

void MainWindow::beginTrial(Trial trial) {
    playback_->end();
    switchOff();
    const ServoTelemetry& servo = engine_.servo();
    const DeviceInfo& device = engine_.device();
    const TrialFigures figures{.centre = servo.frame.offset,
                               .radius = servo.frame.scale * radiusOf(device),
                               .maxForce = device.maxForce,
                               .ceiling =
                                   ceilingNow(servo, device).value}; // not the one that is shown, which waits
    trial_ = trial;
    const auto scene = std::make_shared<const Scene>(trialScene(trial, figures));
    publisher_.setTrial(scene);
    view_->setSelection({});
    view_->setScene(*scene);
    view_->setProxyRadius(scene->proxyRadius);
    centre_->setCurrentWidget(view_);
    view_->fit();
    hand_->placeAt(figures.centre);
    showTrial();
}

/// Safe to call when nothing is tried. Forces off: the finger may be inside of the person's model.
void MainWindow::endTrial() {
    if (!trial_) return;
    trial_.reset();
    switchOff();
    publisher_.setTrial(nullptr);
    showOwnScene();
    showTrial();
}

/// After something else was felt in its place.
void MainWindow::showOwnScene() {
    view_->setScene(document_.scene());
    view_->setProxyRadius(document_.scene().proxyRadius);
    view_->setSelection(document_.selected());
    if (!document_.empty()) view_->fit();
    showCentre();
    hand_->placeBeside();
}

void MainWindow::showTrial() {
    for (const auto& [id, trial] : kTrials)
        actions_[id].setChecked(trial_ == trial);
    actions_["trial-end"].setEnabled(trial_.has_value());
    devicePanel_->trial().setTrial(trial_);
}

} // namespace tactum
