// A value as a bar, with a mark where something begins.
#pragma once

#include <QWidget>

namespace tactum {

class LevelBar : public QWidget {
public:
    explicit LevelBar(QWidget* parent = nullptr);

    /// `mark` and `top` in the unit of `value`; the part of the bar beyond the mark is red. `word` stands at
    /// the mark.
    void setLevel(double value, double mark, double top, const QString& word);
    QSize sizeHint() const override { return {120, 28}; }
    QSize minimumSizeHint() const override { return {64, 28}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double value_ = 0, mark_ = 1, top_ = 1;
    QString word_;
};

} // namespace tactum
