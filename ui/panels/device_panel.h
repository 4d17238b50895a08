// The dock "Device": connecting one, how it does, how its workspace lies, and scenes to try it with.
#pragma once

#include <array>

#include <QWidget>

class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace tactum {

class DeviceConnect;
class DeviceLink;
class DeviceLive;
class DeviceTrialPage;
class Engine;
class HandList;
class WorkspaceFields;

/// Four pages under one line that always says which device it is, whether it may push, and lets the person
/// decide that, for all hands at once. Where there are several they are listed, and the pages are about the
/// chosen one. Thread: ui.
class DevicePanel : public QWidget {
    Q_OBJECT
public:
    enum class Page { Connect, Live, Workspace, Trial };

    explicit DevicePanel(DeviceLink& link, QWidget* parent = nullptr);

    HandList& hands() { return *hands_; }
    DeviceConnect& connecting() { return *connect_; }
    DeviceLive& live() { return *live_; }
    WorkspaceFields& workspace() { return *workspace_; }
    DeviceTrialPage& trial() { return *trial_; }
    void showPage(Page page);
    /// Once a frame. `remedy`: what the button does after a fault; empty while there is none.
    void display(const Engine& engine, const QString& remedy = {});

signals:
    void armPressed(bool armed);

private:
    QWidget* makeHead();
    QWidget* makePages();
    void showState(const Engine& engine, const QString& remedy);

    DeviceLink& link_;
    QLabel *name_, *state_;
    QPushButton* arm_;
    HandList* hands_;
    std::array<QToolButton*, 4> tabs_{};
    QStackedWidget* pages_;
    DeviceConnect* connect_;
    DeviceLive* live_;
    WorkspaceFields* workspace_;
    DeviceTrialPage* trial_;
    bool armed_ = false;
};

} // namespace tactum
