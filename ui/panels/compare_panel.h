// The dock "Compare": a stroke over two states of the scene, and the difference in figures.
#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;

namespace tactum {

class CompareChart;
class Comparison;

/// Thread: ui.
class ComparePanel : public QWidget {
    Q_OBJECT
public:
    explicit ComparePanel(Comparison& comparison, QWidget* parent = nullptr);

signals:
    /// A file for the rows of both touches is wanted.
    void exportAsked();

private:
    QPushButton* addButton(const QString& text, const char* name, const QString& meaning);
    void refresh();
    QString hint() const;

    Comparison& comparison_;
    QPushButton *record_, *last_, *mark_, *swap_, *export_;
    QCheckBox* automatic_;
    CompareChart* chart_;
    QLabel* figures_;
};

/// "rms 0.32 N", "largest 0.81 N at 1.24 s" and so on, a line each.
QString figuresOf(const Comparison& comparison);

} // namespace tactum
