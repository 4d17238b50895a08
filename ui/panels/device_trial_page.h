// The page "Try it" of the dock Device: small scenes to feel, with the limits that hold.
#pragma once

#include <array>
#include <optional>

#include <QWidget>

#include "ui/engine/device_trial.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace tactum {

class Engine;
class ForceMeter;
struct CeilingNow;

/// Thread: ui.
class DeviceTrialPage : public QWidget {
    Q_OBJECT
public:
    explicit DeviceTrialPage(QWidget* parent = nullptr);

    void setTrial(std::optional<Trial> trial);
    /// Once a frame while it is visible.
    void display(const Engine& engine);

signals:
    void chosen(tactum::Trial trial);
    void endPressed();

private:
    void showLimits(const Engine& engine);

    std::array<QToolButton*, 3> buttons_{};
    std::optional<Trial> trial_;
    QLabel *task_, *state_, *limits_;
    ForceMeter* force_;
    QPushButton* end_;
    int frames_ = 0;
};

} // namespace tactum
