// How well the loops run, how stiff surfaces may be, and what was done about it when something was wrong.
#pragma once

#include <deque>
#include <vector>

#include <QScrollArea>

#include "core/runtime/engine.h"
#include "ui/engine/health_words.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace tactum {

class EventList;
class LevelBar;
class PeriodChart;
struct HealthEvent;

/// Sections side by side, as many as the width allows: loops, their regularity, energy and motors, stiffness,
/// events. Every figure's tooltip says what it means and what to do. Thread: ui.
class HealthPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit HealthPanel(QWidget* parent = nullptr);

    /// Cheap; ten times a second is more than a person reads.
    void display(const ServoTelemetry& servo, const ProxyTelemetry& proxy, const DeviceInfo& device);
    void displayCeiling(const CeilingNow& ceiling, const Stiffest& stiffest, bool overridden);
    void setEvents(const std::deque<HealthEvent>& events);
    /// What is displayed is a recording's: nothing can be decided, and some is not known.
    void setRecorded(bool recorded);
    QSize minimumSizeHint() const override { return {200, 96}; }

signals:
    /// The person wants it so; the box follows displayCeiling().
    void overrideAsked(bool on);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QVBoxLayout* addSection(const QString& title);
    void addLoops();
    void addPeriods();
    void addEnergy();
    void addStiffness();
    void addEvents();
    void arrange();
    void displayLoops(const ServoTelemetry& servo, const ProxyTelemetry& proxy, const DeviceInfo& device);
    void displayPeriods(const ServoTelemetry& servo, const DeviceInfo& device);
    void displayEnergy(const ServoTelemetry& servo);

    QWidget* body_;
    QGridLayout* grid_;
    std::vector<QWidget*> sections_;
    int columns_ = 0;
    bool recorded_ = false;
    QLabel *servo_, *proxy_, *gap_, *late_, *fidelity_;
    QLabel* spread_;
    PeriodChart* periods_;
    QLabel *energy_, *damping_, *heat_;
    LevelBar *energyBar_, *heatBar_;
    QLabel *ceiling_, *reason_, *stiffest_, *rendered_;
    LevelBar* stiffnessBar_;
    QCheckBox* override_;
    EventList* events_;
};

} // namespace tactum
