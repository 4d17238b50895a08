// The page "Workspace" of the dock Device: how the device's workspace lies in the scene.
#pragma once

#include <array>
#include <optional>

#include <QWidget>

#include "ui/document/document.h"
#include "ui/engine/axis_capture.h"
#include "ui/engine/device_settings.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace tactum {

class ParameterField;

/// Thread: ui.
class WorkspaceFields : public QWidget {
    Q_OBJECT
public:
    explicit WorkspaceFields(QWidget* parent = nullptr);

    /// `buttons`: how many the device has; `radius`: of its workspace, m. Not `possible`: a simulated hand,
    /// which the mouse leads in the scene itself.
    void show(const Workspace& workspace, int buttons, double radius, bool possible);
    /// What the scene says.
    void showReach(const Reach& reach);
    /// Once a frame: where the handle is, frame D, and where rate control begins, m; 0: nowhere.
    void follow(const Vec3& handle, double border = 0);
    bool capturing() const { return capture_.has_value(); }
    void beginCapture();
    void endCapture();

signals:
    /// As the person wants it now.
    void edited(const tactum::Workspace& workspace);
    /// Of the scene, and for every hand.
    void reachChosen(const tactum::Reach& reach, tactum::Gesture gesture);
    void centrePressed();
    void fitPressed();
    /// The person is about to move the handle: forces off.
    void captureBegun();

private:
    QWidget* makeAxes();
    QWidget* makeCapture();
    QWidget* makeReach();
    void choose(std::size_t which, int row);
    void showCapture();
    void set(const Workspace& workspace);

    Workspace workspace_;
    double radius_ = 0;
    bool possible_ = false;
    std::optional<AxisCapture> capture_;
    QLabel* hint_;
    QWidget* fields_;
    ParameterField* scale_;
    QComboBox* reach_;
    ParameterField* shell_;
    QLabel* beyond_;
    Reach sceneReach_;
    std::array<QComboBox*, 3> axes_{};
    QComboBox* clutch_;
    QCheckBox* bump_;
    QPushButton *centre_, *fit_, *capturing_;
    QLabel* task_;
    QProgressBar* taskBar_;
};

} // namespace tactum
