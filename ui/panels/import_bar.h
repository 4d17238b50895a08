// Over the view after a file was opened that leaves open what one unit of it is, or which axis is up.
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "ui/document/taken_as.h"

class QBoxLayout;
class QButtonGroup;
class QLabel;
class QToolButton;

namespace tactum {

/// Says as what the file was taken and how large that is, and asks for another choice. Thread: ui.
class ImportBar : public QWidget {
    Q_OBJECT
public:
    explicit ImportBar(QWidget* parent = nullptr);

    /// `across`: of the model as it is felt, in m; nothing while the file is read that way.
    void display(const QString& file, const TakenAs& taken, std::optional<double> across);
    QSize minimumSizeHint() const override;

signals:
    /// Others than are shown, from which the next choice goes on.
    void chosen(const tactum::FileAxes& axes);
    /// It may be of another height now.
    void arranged();
    /// The person has seen it.
    void closed();

protected:
    void changeEvent(QEvent* event) override; ///< another theme
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override; ///< how wide there is room

private:
    void choose(const FileAxes& axes);
    void arrange(bool inOneRow, bool withLabels, const QString& text);
    void fit();
    QWidget* makeChoice(QButtonGroup& group, const QString& label);
    void refreshIcons();

    QLabel* text_;
    QLabel* size_;
    QToolButton* close_;
    QBoxLayout *second_, *third_; ///< the choices; the second of them and the size
    std::vector<QLabel*> labels_; ///< before each
    QButtonGroup* units_;         ///< ids: places in kLengthUnits
    QButtonGroup* ups_;           ///< 0: y, 1: z
    QWidget* unitChoice_ = nullptr;
    QWidget* upChoice_ = nullptr;
    QString file_;
    TakenAs taken_;
};

} // namespace tactum
