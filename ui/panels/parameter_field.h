// One row of an inspector, made from one row of a parameter table.
#pragma once

#include <optional>

#include <QElapsedTimer>
#include <QWidget>

#include "core/surface/parameter.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/document/document.h"

class QLabel;
class QToolButton;

namespace tactum {

class NumberBox;
class ValueSlider;

/// Label, value with its unit, slider, and a button back to the default. The value's widget has the
/// parameter's key for its object name, the slider "<key>-slider", the button "<key>-reset", the hint
/// "<key>-hint".
class ParameterField : public QWidget {
    Q_OBJECT
public:
    /// `parameter` must outlive the field; the tables are constants.
    explicit ParameterField(const Parameter& parameter, QWidget* parent = nullptr);

    /// For a row with little room: without the button back to the default, which a double click on the label
    /// does as well.
    void setCompact(int width = 7 * kRhythm);
    /// Shows a value in the parameter's own unit, without telling anybody.
    void setValue(double value);
    /// Whether the value is only the first of several.
    void setMixed(bool mixed);
    /// A tick on the slider, and a line in the tooltip.
    void setCeiling(std::optional<double> ceiling, const QString& meaning);

signals:
    /// A person set the value, in the parameter's own unit.
    void edited(double value, tactum::Gesture gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void layOut(QLabel* label);
    void wire();
    void useUnit(); ///< that the person prefers
    void describe();
    void showLimit(double typed);
    void showMistake(const QString& typed);
    void edit(double value, Gesture gesture);
    void followSlider();
    Gesture stepGesture();

    const Parameter& parameter_;
    DisplayUnit unit_;
    double value_ = 0; ///< shown, in the parameter's own unit
    NumberBox* box_;
    ValueSlider* slider_;
    QToolButton* reset_;
    QLabel* unitLabel_;
    bool compact_ = false;
    QLabel* hint_; ///< why another value than the typed one is shown
    QString ceilingText_;
    QElapsedTimer sinceStep_;
    Gesture gesture_ = 0;
};

} // namespace tactum
