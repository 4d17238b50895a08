// A device on its way: its steps, what the person has to do, how far it is, and how it went wrong.
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace tactum {

struct Preparation;

/// Thread: ui.
class DeviceSteps : public QWidget {
    Q_OBJECT
public:
    explicit DeviceSteps(QWidget* parent = nullptr);

    /// Hides itself while there is nothing to tell.
    void show(const Preparation& preparation);

signals:
    void giveUpPressed();
    void againPressed();

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void fillRows(const Preparation& preparation);

    QLabel* heading_;
    QVBoxLayout* rows_;
    QLabel* request_;
    QProgressBar* bar_;
    QLabel* failure_;
    QPushButton *giveUp_, *again_;
    QString shown_; ///< rows as they are, to make them anew only when they differ
};

} // namespace tactum
