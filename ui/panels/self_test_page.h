// One part of a self-test: what the person does, in large letters, and what the device says meanwhile.
#pragma once

#include <optional>

#include <QElapsedTimer>
#include <QWidget>

#include "ui/engine/self_test_run.h"

class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace tactum {

class ForceMeter;
class WorkspacePicture;

class SelfTestPage : public QWidget {
    Q_OBJECT
public:
    explicit SelfTestPage(QWidget* parent = nullptr);

    void showPreparing(const QString& step, const QString& request);
    void showPart(TrialPart part);
    void ask(const TrialQuestion& question);
    /// What the device does now, by itself.
    void tell(const QString& words);
    void showEnding();
    /// Once a frame.
    void show(const TrialLook& look, const DeviceInfo& device);

signals:
    void done();
    void skipped();
    /// kg, that hangs on the handle.
    void massGiven(double mass);
    void cancelled();

private:
    QWidget* makeButtons();
    void goOn();
    void wait();
    void aimFor(TrialAsk ask);
    void say(const QString& words);

    QLabel *heading_, *words_, *doing_, *rate_;
    QWidget* massRow_;
    QDoubleSpinBox* mass_;
    WorkspacePicture* picture_;
    ForceMeter* force_;
    QProgressBar* progress_;
    QPushButton *continue_ = nullptr, *skip_ = nullptr, *cancel_ = nullptr;
    TrialPart part_ = TrialPart::Rest;
    bool asksMass_ = false;
    Vec3 handle_ = Vec3::Zero(), zero_ = Vec3::Zero(); ///< now, and at the beginning of the ruler
    TrialAsk ask_ = TrialAsk::LetGo;
    std::uint64_t readings_ = 0;
    QElapsedTimer counted_;
};

} // namespace tactum
