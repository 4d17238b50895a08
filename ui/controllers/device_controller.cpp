#include "ui/controllers/device_controller.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include <cassert>
#include <cmath>
#include <limits>

#include "ui/controllers/arming.h"
#include "ui/controllers/command_reasons.h"
#include "ui/controllers/folds.h"
#include "ui/document/document.h"
#include "ui/engine/device_link.h"
#include "ui/engine/hand_name.h"
#include "ui/engine/usb_permission.h"
#include "ui/engine/world_publisher.h"
#include "ui/panels/device_connect.h"
#include "ui/panels/device_live.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/hand_list.h"
#include "ui/panels/workspace_fields.h"
#include "ui/showing/playback.h"
#include "ui/tools/hand_link.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

DeviceController::DeviceController(const Workbench& bench, Arming& arming, DeviceLink& link, HandLink& hand,
                                   TouchHint& hint, Folds& folds, DevicePanel& panel)
    : QObject(&bench.window), bench_(bench), arming_(arming), link_(link), hand_(hand), hint_(hint),
      folds_(folds), panel_(panel), permission_(new UsbPermission(this)), settings_(link.hands().count()) {
    connectCommands();
    connectLink();
    connectHands();
    connectConnecting();
    connectLive();
    connectWorkspace();
    connect(&panel, &DevicePanel::armPressed, &arming, &Arming::set);
    lead();
    bench.window.menuBar()->findChild<QMenu*>(QStringLiteral("Device"))->setToolTipsVisible(true);
    showSettings();
    showCommands();
}

void DeviceController::choose() {
    link_.choose(panel_.connecting().chosen());
}

void DeviceController::connectCommands() {
    bench_.on("device-panel", this, [this] { showPage(int(DevicePanel::Page::Connect)); });
    bench_.on("device-connect", this, [this] { choose(); });
    bench_.on("device-disconnect", this, [this] { link_.choose(kSimulatedDevice); });
    bench_.on("hand-add", this, [this] { addHand(); });
    bench_.on("hand-next", this, [this] { chooseNextHand(); });
    bench_.on("hand-remove", this, [this] { link_.remove(link_.hands().chosen()); });
    bench_.on("workspace-centre", this, [this] { centreWorkspace(false); });
    bench_.on("workspace-fit", this, [this] { centreWorkspace(true); });
    bench_.on("workspace-axes", this, [this] {
        showPage(int(DevicePanel::Page::Workspace));
        panel_.workspace().beginCapture();
    });
}

void DeviceController::connectLink() {
    connect(&link_, &DeviceLink::exchanged, this, &DeviceController::adopt);
    connect(&link_, &DeviceLink::handsFollowed, this, [this] {
        settings_.resize(link_.hands().count());
        lead();
        showSettings();
        showCommands();
    });
    connect(&link_, &DeviceLink::ready, this, &DeviceController::offerReady);
    connect(&link_, &DeviceLink::failed, &bench_.notice, &NoticeBar::showError);
    connect(&link_, &DeviceLink::supplied, &bench_.notice, &NoticeBar::showNote);
    connect(&link_, &DeviceLink::preparationChanged, this, &DeviceController::showCommands);
    connect(&link_, &DeviceLink::preparationChanged, this, &DeviceController::sayRequest);
}

void DeviceController::connectHands() {
    connect(&panel_.hands(), &HandList::handChosen, this, &DeviceController::chooseHand);
    connect(&panel_.hands(), &HandList::removePressed, &link_, &DeviceLink::remove);
    connect(&panel_.connecting(), &DeviceConnect::addPressed, this, &DeviceController::addHand);
    connect(&link_, &DeviceLink::wentAway, this, [this](const QString& name, bool others) {
        away_ = (others ? tr("%1 is not there any more and gets no force; the other hand goes on. When you "
                             "switch the forces off, the mouse leads a simulated hand in its place.")
                        : tr("%1 is not there any more; the forces are off. Plug it in: it is made ready "
                             "again by itself. Until then the mouse leads a simulated hand."))
                    .arg(name);
        sayAway();
    });
    connect(&link_, &DeviceLink::missing, this, [this](const QStringList& names) {
        bench_.notice.showNote(tr("Not there since last time: %1. What you plug in is made ready by itself.")
                                   .arg(names.join(QStringLiteral(", "))));
    });
    connect(&link_, &DeviceLink::besideWentAway, this, [this](const QString& name, bool others) {
        away_ = (others ? tr("%1 is not there any more and gets no force; the other hand goes on. Its own "
                             "goes when you switch the forces off. Plug it in: it is made ready again by "
                             "itself.")
                        : tr("%1 is not there any more, and its hand went with it. Plug it in: it is made "
                             "ready again by itself."))
                    .arg(name);
        sayAway();
    });
}

void DeviceController::addHand() {
    arming_.switchOff(); // nothing pushes while the person is busy with another device
    link_.add(panel_.connecting().chosen());
}

void DeviceController::chooseNextHand() {
    Playback& playback = bench_.playback;
    if (playback.active())
        playback.showHand((playback.hand() + 1) % playback.player().run().hands());
    else
        chooseHand((link_.hands().chosen() + 1) % link_.hands().count());
}

void DeviceController::chooseHand(std::size_t hand) {
    link_.hands().choose(hand);
    showSettings();
    showCommands();
    emit handChosen();
}

void DeviceController::showHands() {
    Hands& hands = link_.hands();
    const auto markOf = [&](std::size_t hand) {
        return HandMark{.number = hand,
                        .name = handName(hands, hand),
                        .led = link_.simulatedHand() == hand || hands.count() == 1};
    };
    std::vector<HandBeside> beside;
    for (std::size_t hand = 0; hand < hands.count(); ++hand)
        if (hand != hands.chosen() && !link_.gone(hand))
            beside.push_back({markOf(hand), hands.touch(hand), hands.servo(hand), hands.device(hand).maxForce,
                              hands.armed(hand)});
    bench_.view.setHands(markOf(hands.chosen()), beside);
}

void DeviceController::connectConnecting() {
    DeviceConnect& connecting = panel_.connecting();
    connect(&connecting, &DeviceConnect::connectPressed, this, [this] { choose(); });
    connect(&connecting, &DeviceConnect::disconnectPressed, this, [this] { link_.choose(kSimulatedDevice); });
    connect(&connecting, &DeviceConnect::chosenChanged, this, &DeviceController::showCommands);
    connect(&connecting, &DeviceConnect::permissionPressed, permission_, &UsbPermission::ask);
    connecting.setLacksRealTime(lacksRealTime());
    connect(permission_, &UsbPermission::refused, &connecting, &DeviceConnect::showCommand);
    connect(permission_, &UsbPermission::granted, this, [this] {
        bench_.notice.showNote(
            tr("You may use USB devices now, and real time when you have logged in again. If yours is still "
               "not usable, plug it in anew."));
        panel_.connecting().setLacksRealTime(lacksRealTime());
        link_.look();
    });
}

void DeviceController::connectLive() {
    connect(&panel_.live(), &DeviceLive::stopButtonChosen, this, [this](std::uint32_t button) {
        DeviceSettings next = settings();
        next.stopButton = button;
        next.workspace.clutch &= ~button; // a button does one thing
        setSettings(next);
    });
    connect(&panel_.live(), &DeviceLive::graspChosen, this, [this](bool grasped) {
        DeviceSettings next = settings();
        next.grasped = grasped;
        setSettings(next);
    });
}

void DeviceController::connectWorkspace() {
    WorkspaceFields& workspace = panel_.workspace();
    connect(&workspace, &WorkspaceFields::edited, this, &DeviceController::setWorkspace);
    connect(&workspace, &WorkspaceFields::reachChosen, &bench_.document, &Document::setReach);
    connect(&bench_.document, &Document::changed, this, &DeviceController::applyReach);
    connect(&bench_.publisher, &WorldPublisher::published, this, &DeviceController::applyReach);
    workspace.showReach(bench_.document.scene().reach);
    connect(&workspace, &WorkspaceFields::centrePressed, this, [this] { centreWorkspace(false); });
    connect(&workspace, &WorkspaceFields::fitPressed, this, [this] { centreWorkspace(true); });
    connect(&workspace, &WorkspaceFields::captureBegun, &arming_, &Arming::switchOff);
}

void DeviceController::showPage(int page) {
    folds_.bringForward(bench_.dock("dock-device"));
    panel_.showPage(DevicePanel::Page(page));
    panel_.setFocus(Qt::ShortcutFocusReason);
}

/// Whether the mouse leads a hand.
bool DeviceController::lead() {
    const auto led = link_.simulatedHand();
    hand_.setIdle(!led);
    hand_.setHand(led.value_or(0));
    return led.has_value();
}

/// Another device is in the engine, without force.
void DeviceController::adopt() {
    arming_.adoptDevice();
    if (!lead()) hint_.hide(); // the mouse leads nothing
    settings_.assign(link_.hands().count(), {});
    for (std::size_t hand = 0; hand < settings_.size(); ++hand)
        apply(hand, link_.leadsItself(hand) ? rememberedSettings(link_.idOf(hand)) : DeviceSettings{});
    showSettings();
    showCommands();
    emit adopted();
}

// How a person's device lies in the scene, and what its buttons do, belongs to neither the scene nor its
// history: the same scene is felt with other devices, and undoing an edit must not move somebody's hand.
void DeviceController::apply(std::size_t hand, const DeviceSettings& settings) {
    DeviceSettings next = settings;
    next.workspace.reach = link_.leadsItself(hand) ? bench_.publisher.scene().reach : Reach{};
    if (const auto possible = link_.hands().setWorkspace(hand, next.workspace); !possible) {
        bench_.notice.showError(QString::fromStdString(possible.error().text));
        next.workspace = settings_[hand].workspace; // nor is it there at the next start
    }
    settings_[hand] = next;
    link_.stop(hand).buttons = settings.stopButton;
    link_.hands().setGrasped(hand, settings.grasped);
    if (link_.leadsItself(hand)) rememberSettings(link_.idOf(hand), next);
}

/// How hands reach is of the scene that is felt, and undone with it: it moves nobody's hand by itself.
void DeviceController::applyReach() {
    panel_.workspace().showReach(bench_.document.scene().reach);
    bool other = false;
    for (std::size_t hand = 0; hand < settings_.size() && hand < link_.hands().count(); ++hand) {
        if (!link_.leadsItself(hand) || settings_[hand].workspace.reach == bench_.publisher.scene().reach)
            continue;
        apply(hand, DeviceSettings(settings_[hand]));
        other = true;
    }
    if (other) showSettings();
}

const DeviceSettings& DeviceController::settings() const {
    assert(link_.hands().chosen() < settings_.size());
    return settings_[link_.hands().chosen()];
}

void DeviceController::setSettings(const DeviceSettings& settings) {
    apply(link_.hands().chosen(), settings);
    showSettings();
}

void DeviceController::showSettings() {
    const DeviceInfo& device = bench_.engine.device();
    const bool real = link_.leadsItself(link_.hands().chosen());
    panel_.live().setGrasped(settings().grasped, real);
    panel_.live().setStopButton(settings().stopButton, device.buttons, real);
    panel_.workspace().show(settings().workspace, device.buttons, device.workspaceRadius, real);
}

void DeviceController::setWorkspace(const Workspace& workspace) {
    DeviceSettings next = settings();
    next.workspace = workspace;
    next.stopButton &= ~workspace.clutch; // a button does one thing
    setSettings(next);
}

void DeviceController::centreWorkspace(bool fit) {
    if (!link_.leadsItself(link_.hands().chosen())) return;
    const Bounds model = boundsOf(bench_.document.scene());
    Workspace next = settings().workspace;
    next.offset = model.empty() ? Vec3(Vec3::Zero()) : model.centre();
    if (fit && model.diagonal() > 0)
        next.scale = kWorkspaceScale.clamped(0.5 * model.diagonal() / usualRadius(bench_.engine.device()));
    ++next.centring;
    setWorkspace(next);
}

/// Once a frame.
void DeviceController::frame() {
    link_.frame();
    panel_.display(bench_.engine, arming_.faulty() ? arming_.again() : QString());
    // The device itself has been without force since the tick that read the button.
    Hands& hands = link_.hands();
    bool pressed = false;
    for (std::size_t hand = 0; hand < hands.count(); ++hand)
        pressed = pressed || (link_.stop(hand).pressed && hands.armed(hand));
    if (!pressed) return;
    arming_.set(false);
    bench_.notice.showNote(tr("Stopped by the button of the device. Device > Forces on goes on."));
}

void DeviceController::offerReady(const QString& name, bool back) {
    bench_.notice.offer((back ? tr("%1 is there and ready. The forces are off: hold the handle, then arm.")
                              : tr("%1 is ready. The forces are off: hold the handle, then arm."))
                            .arg(name),
                        QStringLiteral("note"), tr("Arm"), [this] { arming_.set(true); });
}

/// A device that was remembered is made ready by itself, and waits for a person who may look elsewhere.
void DeviceController::sayRequest() {
    const Preparation& preparation = link_.preparation();
    if (preparation.request.isEmpty()) return bench_.notice.withdraw(tr("Show"));
    const QString text = QStringLiteral("%1: %2").arg(preparation.name, preparation.request);
    if (!panel_.visibleRegion().isEmpty() || bench_.notice.text() == text) return;
    bench_.notice.offer(text, QStringLiteral("note"), tr("Show"),
                        [this] { showPage(int(DevicePanel::Page::Connect)); });
}

void DeviceController::sayAway(const QString& more) {
    bench_.notice.showError(QStringLiteral("%1 %2").arg(away_, more).trimmed());
}

void DeviceController::showCommands() {
    const bool leadsItself = link_.leadsItself(link_.hands().chosen());
    const bool live = !bench_.playback.active();
    const QString shown = live ? QString() : whyOff({}, true);
    const std::size_t hands = live ? link_.hands().count() : bench_.playback.player().run().hands();
    bench_.actions.allow("hand-add", live ? panel_.connecting().whyNotAdd() : shown);
    bench_.actions["hand-next"].setEnabled(hands > 1);
    const bool beside = live && link_.hands().chosen() > 0;
    bench_.actions.allow("hand-remove", !beside                ? whyOff(QStringLiteral("hand-remove"), !live)
                                        : link_.hasCatalogue() ? QString()
                                                               : tr("The hands are the server's."));
    bench_.actions.allow("device-connect", panel_.connecting().whyNotConnect());
    bench_.actions.allow("device-disconnect", link_.whyNotLetGo());
    const QString whyNot =
        !live || leadsItself ? shown : tr("The mouse leads the simulated hand in the scene itself.");
    for (const char* id : {"workspace-centre", "workspace-fit", "workspace-axes"})
        bench_.actions.allow(id, whyNot);
}

} // namespace tactum
