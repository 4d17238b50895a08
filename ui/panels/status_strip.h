// The state of the haptics in one line, always visible, with the button that ends all force.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "core/runtime/engine.h"

class QLabel;
class QPushButton;

namespace tactum {

class ForceMeter;

/// Device and whether forces are on, rates, jitter, update time, contacts, force against the limit, STOP.
/// A fault colours the strip and says what happened, what was done and how to go on, with a button for it.
class StatusStrip : public QWidget {
    Q_OBJECT
public:
    explicit StatusStrip(QWidget* parent = nullptr);

    /// Thread: ui, once a frame.
    void display(const Engine& engine);
    /// A moment of a recording, made with that device.
    void display(const ProxyTelemetry& proxy, const ServoTelemetry& servo, const DeviceInfo& device);
    /// Whether another hand than the one displayed may push: STOP is for it, too.
    void setOthersPush(bool push) { othersPush_ = push; }
    /// The name of the surface that is touched, instead of how many push; empty for none.
    void setTouched(const QString& name) { touched_ = name; }
    /// Instead of the priority note while nothing is touched: what the mouse is over. May be empty.
    void setHovered(const QString& words) { hovered_ = words; }
    /// Instead of figures and note, until cleared with an empty one. `remedy`: what its button says.
    void setFault(const QString& sentences, const QString& remedy = {});
    /// Instead of the priority note: why there is less force than usual, or less detail. May be empty.
    void setQuietNote(const QString& sentences) { quiet_ = sentences; }
    /// With STOP, the device, the force and what is touched; the rates give way.
    QSize minimumSizeHint() const override;

signals:
    void armPressed();
    void stopPressed();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QLabel* addReading(const QString& name, const QString& meaning, const QString& widest);
    void showDevice(const std::string& name, const QString& state);
    void showReadings();
    int deviceRoom() const;
    int least() const;
    void showTouch(const ProxyTelemetry& proxy, const ServoTelemetry& servo, const DeviceInfo& device);

    QString priorityWords(const std::string& english);
    void showNote(const QString& note);

    QLabel* device_;
    QLabel* servo_;
    QLabel* proxy_;
    QLabel* contacts_;
    ForceMeter* force_;
    QLabel* note_;
    QPushButton* arm_;
    QPushButton* stop_;
    std::string english_; ///< of the priority note
    QString priority_;    ///< the same in words
    QString fault_, quiet_, touched_, hovered_;
    bool othersPush_ = false;
    QElapsedTimer sinceRates_; ///< were shown
};

} // namespace tactum
