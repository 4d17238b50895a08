// Over the view after a file was opened that leaves open what one unit of it is, or which axis is up.
#pragma once

#include <QWidget>

#include "ui/taken_as.h"

class QButtonGroup;
class QLabel;
class QToolButton;

namespace tactum {

/// Says as what the file was taken and how large that is, and asks for another choice. Thread: ui.
class ImportBar : public QWidget {
    Q_OBJECT
public:
    explicit ImportBar(QWidget* parent = nullptr);

    /// `across`: of the model as it is felt, in m.
    void display(const QString& file, const TakenAs& taken, double across);

signals:
    void unitChosen(double metres);
    void upChosen(bool zUp);
    /// The person has seen it.
    void closed();

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    QWidget* makeChoice(QButtonGroup& group, const QString& label);
    void refreshIcons();

    QLabel* text_;
    QLabel* size_;
    QToolButton* close_;
    QButtonGroup* units_; ///< ids: places in kLengthUnits
    QButtonGroup* ups_;   ///< 0: y, 1: z
    QWidget* unitChoice_ = nullptr;
    QWidget* upChoice_ = nullptr;
    TakenAs taken_;
};

} // namespace tactum
