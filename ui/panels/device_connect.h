// The page "Connect" of the dock Device: which devices there are, and making one ready.
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace tactum {

class DeviceLink;
class DeviceSteps;

/// Thread: ui.
class DeviceConnect : public QWidget {
    Q_OBJECT
public:
    explicit DeviceConnect(DeviceLink& link, QWidget* parent = nullptr);

    /// Id of the chosen row; empty when there is none, or when its device cannot be used.
    QString chosen() const;
    /// Why what is chosen cannot be connected; empty: it can.
    QString whyNotConnect() const;
    QString whyNotAdd() const;
    /// The device is at a haptic server and nothing can be chosen here. `device`: its name; empty while the
    /// server is not there.
    void showServer(const QString& place, const QString& device);
    /// A line for a terminal, to be copied; with the sentence that leads to it.
    void showCommand(const QString& sentence, const QString& command);
    /// Permission is offered for the loops' sake, too.
    void setLacksRealTime(bool lacks);

signals:
    void connectPressed();
    void disconnectPressed();
    void addPressed();
    void permissionPressed();
    /// Another row, or another state of it.
    void chosenChanged();

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void fill();
    void follow();
    QString whyNotOf(QString (DeviceLink::*why)(const QString&) const) const;
    void askForFile();

    DeviceLink& link_;
    QTreeWidget* list_;
    QPushButton *connect_, *disconnect_, *add_, *permit_, *supply_;
    QLabel *sentence_, *server_;
    QLineEdit* command_;
    QPushButton* copy_;
    DeviceSteps* steps_;
    bool lacksRealTime_ = false;
};

/// Whether a device is listed that the person's account may not open.
bool wantsPermission(const DeviceLink& link);

} // namespace tactum
