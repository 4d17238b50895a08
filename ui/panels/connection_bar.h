// Over the view while it shows a scene of a haptic server: where, who else is there, who may edit.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace tactum {

struct SharedState;

class ConnectionBar : public QWidget {
    Q_OBJECT
public:
    explicit ConnectionBar(QWidget* parent = nullptr);

    void display(const SharedState& state);
    QString text() const;

signals:
    void penWanted();

private:
    QLabel* text_;
    QPushButton* ask_;
};

} // namespace tactum
