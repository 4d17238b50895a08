// A person is led through the self-test of a device.
#pragma once

#include <memory>

#include <QDialog>
#include <QTimer>

#include "ui/engine/self_test_run.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace tactum {

class SelfTestPage;
class SelfTestResult;

/// What comes first is what will happen; then a page for what is to be done; then what was found. Esc, Cancel
/// and the window's cross end it: the force goes at once, and the dialog when the device is closed.
/// Thread: ui.
class SelfTestDialog : public QDialog {
    Q_OBJECT
public:
    SelfTestDialog(const QString& name, QWidget* parent);

    /// The device that start() asked for, or why there is none.
    void begin(std::unique_ptr<HapticDevice> device, const SelfTestPace& pace);
    void fail(const QString& sentence);
    /// What became of keep().
    void tellKept(const QString& words, bool wrong);
    void reject() override;

signals:
    /// The person starts: the device is wanted, by begin().
    void started();
    /// The figures are to be kept.
    void keep(const tactum::SelfTestReport& report);

private:
    QWidget* makeIntroduction(const QString& name);
    QWidget* makeEnd();
    void start();
    void look();
    void finishRun();
    void showReport();
    void save();

    QStackedWidget* pages_;
    SelfTestPage* page_;
    SelfTestResult* result_;
    QPushButton* start_ = nullptr;
    QLabel* failure_ = nullptr;
    std::unique_ptr<SelfTestRun> run_;
    std::unique_ptr<SelfTestReport> report_;
    QTimer frames_;
    bool waits_ = false, leaves_ = false; ///< for the device; when that is closed
};

} // namespace tactum
