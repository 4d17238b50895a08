#include "ui/panels/device_connect.h"

#include <algorithm>

#include <QClipboard>
#include <QEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/engine/device_link.h"
#include "ui/panels/device_steps.h"
#include "ui/widgets/columns.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr int kLowest = 8 * kRhythm, kHighest = 26 * kRhythm; // of the list

/// One row of sentences for each device.
class DeviceList final : public HintedTree {
public:
    DeviceList() : HintedTree(DeviceConnect::tr("Looking for devices...")) {
        setObjectName(QStringLiteral("device-list"));
        setAccessibleName(DeviceConnect::tr("Haptic devices"));
        setRootIsDecorated(false);
        setWrapping();
        fit();
    }
    /// As high as its rows, so that the steps have room below.
    void fit() {
        wrapRows();
        int height = kRhythm;
        for (int i = 0; i < topLevelItemCount(); ++i)
            height += topLevelItem(i)->sizeHint(0).height();
        setFixedHeight(std::clamp(height, kLowest, kHighest));
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        HintedTree::resizeEvent(event);
        fit();
    }
};

QString deviceLineOf(const DeviceLink& link, const DeviceListing& listing) {
    const QString id = QString::fromStdString(listing.id);
    const QString name = wordsOf(listing.name), sentence = wordsOf(listing.sentence);
    if (!id.isEmpty() && link.uses(id)) return DeviceConnect::tr("%1 \u00b7 in use\n%2").arg(name, sentence);
    if (!listing.usable && !id.isEmpty())
        return DeviceConnect::tr("%1 \u00b7 not usable\n%2").arg(name, sentence);
    return QStringLiteral("%1\n%2").arg(name, sentence);
}

QIcon deviceIconOf(const DeviceLink& link, const DeviceListing& listing) {
    if (!listing.id.empty() && link.uses(QString::fromStdString(listing.id)))
        return icon(QStringLiteral("check"), theme().contact);
    if (listing.id.empty()) return icon(QStringLiteral("note"), theme().textDimmed);
    return listing.usable ? icon(QStringLiteral("touch"), theme().text)
                          : icon(QStringLiteral("warning"), theme().stick);
}

/// The first device that lacks a file.
const DeviceListing* lackingOne(const DeviceLink& link) {
    const auto found =
        std::ranges::find_if(link.devices(), [](const auto& each) { return !each.lacks.empty(); });
    return found == link.devices().end() ? nullptr : &*found;
}

/// What it lacks, without how such files are called.
QString deviceWordOf(const DeviceListing& listing) {
    return QString::fromStdString(listing.lacks).section(QStringLiteral(" ("), 0, 0);
}

/// Its tool tip says what it does, or why it does nothing now.
void allow(QPushButton& button, const QString& does, const QString& whyNot) {
    button.setEnabled(whyNot.isEmpty());
    button.setToolTip(whyNot.isEmpty() ? does : whyNot);
}

} // namespace

bool wantsPermission(const DeviceLink& link) {
    return std::ranges::any_of(link.devices(), &DeviceListing::forbidden);
}

DeviceConnect::DeviceConnect(DeviceLink& link, QWidget* parent)
    : QWidget(parent), link_(link), list_(new DeviceList), connect_(new QPushButton(tr("Connect"))),
      disconnect_(new QPushButton(tr("Disconnect"))), add_(new QPushButton(tr("Add a device"))),
      permit_(new QPushButton(tr("Let me use devices"))), supply_(new QPushButton), sentence_(new QLabel),
      server_(dimmedLine({})), command_(new QLineEdit), copy_(new QPushButton(tr("Copy"))),
      steps_(new DeviceSteps) {
    connect_->setObjectName(QStringLiteral("device-connect-button"));
    disconnect_->setObjectName(QStringLiteral("device-disconnect-button"));
    add_->setObjectName(QStringLiteral("device-add-button"));
    permit_->setObjectName(QStringLiteral("device-permit"));
    permit_->setToolTip(
        tr("Puts a rule for USB devices and limits for real time where the system looks for them, "
           "after an administrator's consent"));
    supply_->setObjectName(QStringLiteral("device-supply"));
    sentence_->setObjectName(QStringLiteral("device-permit-sentence"));
    sentence_->setWordWrap(true);
    command_->setObjectName(QStringLiteral("device-permit-command"));
    command_->setAccessibleName(tr("Line for a terminal"));
    command_->setReadOnly(true);
    copy_->setObjectName(QStringLiteral("device-permit-copy"));
    server_->setObjectName(QStringLiteral("device-at-server"));
    server_->setTextFormat(Qt::PlainText); // names come from elsewhere
    server_->hide();
    auto* column = columnIn(this, kRhythm);
    column->addWidget(server_);
    column->addWidget(list_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(connect_, 1);
    buttons->addWidget(disconnect_, 1);
    column->addLayout(buttons);
    column->addWidget(add_);
    column->addWidget(permit_);
    column->addWidget(supply_);
    column->addWidget(sentence_);
    auto* line = new QHBoxLayout;
    line->addWidget(command_, 1);
    line->addWidget(copy_);
    column->addLayout(line);
    column->addWidget(steps_);
    column->addStretch();
    showCommand({}, {});
    connect(connect_, &QPushButton::clicked, this, &DeviceConnect::connectPressed);
    connect(disconnect_, &QPushButton::clicked, this, &DeviceConnect::disconnectPressed);
    connect(add_, &QPushButton::clicked, this, &DeviceConnect::addPressed);
    connect(permit_, &QPushButton::clicked, this, &DeviceConnect::permissionPressed);
    connect(supply_, &QPushButton::clicked, this, &DeviceConnect::askForFile);
    connect(copy_, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(command_->text()); });
    connect(steps_, &DeviceSteps::giveUpPressed, &link_, &DeviceLink::giveUp);
    connect(steps_, &DeviceSteps::againPressed, &link_, &DeviceLink::tryAgain);
    connect(list_, &QTreeWidget::currentItemChanged, this, &DeviceConnect::follow);
    connect(list_, &QTreeWidget::itemActivated, this, [this] { emit connectPressed(); });
    connect(&link_, &DeviceLink::listChanged, this, &DeviceConnect::fill);
    connect(&link_, &DeviceLink::exchanged, this, &DeviceConnect::fill);
    connect(&link_, &DeviceLink::preparationChanged, this, &DeviceConnect::follow);
    fill();
}

void DeviceConnect::askForFile() {
    const DeviceListing* lacking = lackingOne(link_);
    if (!lacking) return;
    const QString id = QString::fromStdString(lacking->id); // the list goes on while the dialog is open
    const QString file =
        QFileDialog::getOpenFileName(this, supply_->text(), {}, QString::fromStdString(lacking->lacks));
    if (!file.isEmpty()) link_.supply(id, file);
}

QString DeviceConnect::chosen() const {
    const QTreeWidgetItem* row = list_->currentItem();
    const DeviceListing* listing = row ? link_.find(row->data(0, kIdRole).toString()) : nullptr;
    return listing && listing->usable ? QString::fromStdString(listing->id) : QString();
}

QString DeviceConnect::whyNotConnect() const {
    return whyNotOf(&DeviceLink::whyNotBegin);
}

QString DeviceConnect::whyNotAdd() const {
    return whyNotOf(&DeviceLink::whyNotAdd);
}

QString DeviceConnect::whyNotOf(QString (DeviceLink::*why)(const QString&) const) const {
    if (!server_->isHidden()) return tr("The device is at the haptic server, and is chosen there.");
    const QTreeWidgetItem* row = list_->currentItem();
    if (!row) return tr("Choose a device in the list first.");
    const QString id = chosen();
    return id.isEmpty() ? tr("What is chosen cannot be used; its row says why.") : (link_.*why)(id);
}

void DeviceConnect::showServer(const QString& place, const QString& device) {
    server_->setText(
        device.isEmpty()
            ? tr("The haptic server %1 is not there, and the device is with it. Start it again: the window "
                 "finds it by itself.")
                  .arg(place)
            : tr("%1 is at the haptic server %2. Which device that is is said where the server is started: "
                 "tactum serve --device. One of this computer is connected in a window without a server.")
                  .arg(device, place));
    for (QWidget* each : std::initializer_list<QWidget*>{list_, connect_, disconnect_, add_})
        each->hide();
    server_->show();
    follow();
}

void DeviceConnect::showCommand(const QString& sentence, const QString& command) {
    sentence_->setText(sentence);
    sentence_->setVisible(!sentence.isEmpty());
    command_->setText(command);
    command_->setCursorPosition(0);
    command_->setVisible(!command.isEmpty());
    copy_->setVisible(!command.isEmpty());
}

void DeviceConnect::setLacksRealTime(bool lacks) {
    lacksRealTime_ = lacks;
    follow();
}

void DeviceConnect::fill() {
    const QTreeWidgetItem* before = list_->currentItem();
    const QString kept = before ? before->data(0, kIdRole).toString() : link_.wanted();
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (const DeviceListing& listing : link_.devices()) {
            auto* row = new QTreeWidgetItem(list_, {deviceLineOf(link_, listing)});
            row->setIcon(0, deviceIconOf(link_, listing));
            row->setToolTip(0, wordsOf(listing.sentence));
            row->setData(0, kIdRole, QString::fromStdString(listing.id));
            if (!listing.id.empty() && QString::fromStdString(listing.id) == kept) list_->setCurrentItem(row);
        }
        static_cast<DeviceList*>(list_)->fit();
    }
    follow();
}

void DeviceConnect::follow() {
    steps_->show(link_.preparation());
    const bool wants = server_->isHidden() && (lacksRealTime_ || wantsPermission(link_));
    permit_->setVisible(wants);
    if (!wants) showCommand({}, {});
    const DeviceListing* lacking = lackingOne(link_);
    supply_->setVisible(lacking != nullptr);
    if (lacking) {
        supply_->setText(tr("Choose %1...").arg(deviceWordOf(*lacking)));
        supply_->setToolTip(tr("For the %1. Your copy is checked, and kept where the driver finds it")
                                .arg(QString::fromStdString(lacking->name)));
    }
    allow(*connect_, tr("Make the chosen device ready, step by step"), whyNotConnect());
    allow(*disconnect_, tr("Give the device back; the mouse leads a simulated hand"), link_.whyNotLetGo());
    allow(*add_, tr("Make the chosen device ready as one more hand; those that there are stay"), whyNotAdd());
    emit chosenChanged();
}

void DeviceConnect::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        fill();
        steps_->show(link_.preparation());
    }
    QWidget::changeEvent(event);
}

} // namespace tactum
