// A field for one number: typed, stepped and wheeled, always in the C locale.
#pragma once

#include <optional>

#include <QDoubleSpinBox>

namespace tactum {

/// Right-aligned figures without arrows. A typed comma counts as the decimal point; any unit of the same kind
/// may be typed after the number. Values out of range are brought into it when the entry ends.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit NumberBox(const QString& unit, QWidget* parent = nullptr);

    void setUnit(const QString& unit) { unit_ = unit; }
    /// Shows a word instead of a number: it stands for several values. What is typed counts for all of them.
    void setMixed(bool mixed);

    void stepBy(int steps) override;
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;

signals:
    void typed(double value);
    /// By an arrow key or the wheel.
    void stepped(double value);
    /// What was typed lies beyond an end of the range; the box shows that end now.
    void outOfRange(double typed);
    /// What was typed is no number of this unit; the box shows what it showed before.
    void notUnderstood(const QString& typed);

protected:
    void fixup(QString& text) const override;
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    void noteEntry();
    bool isOfTheProgram(const QKeyEvent& key) const;

    QString unit_;
    std::optional<double> entry_; ///< what is being typed
    mutable QString wrong_;       ///< what was typed, when it was no number of this unit
    bool stepping_ = false, mixed_ = false;
};

} // namespace tactum
