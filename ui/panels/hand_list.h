// The hands that there are, in the dock Device: one row for each, where there are several.
#pragma once

#include <vector>

#include <QWidget>

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace tactum {

class DeviceLink;

/// Each row has the hand's colours in the view, its device and whether that may push; the chosen one is
/// checked. Hidden while there is one hand. Thread: ui.
class HandList : public QWidget {
    Q_OBJECT
public:
    explicit HandList(DeviceLink& link, QWidget* parent = nullptr);

    /// Once a frame.
    void display();

signals:
    void handChosen(std::size_t hand);
    void removePressed(std::size_t hand);

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    struct Row {
        QWidget* line;
        QToolButton* button;
        QToolButton* remove = nullptr; ///< of the first, and where the hands are a server's: none
    };
    void addRow();
    void colour();
    QString textOf(std::size_t hand) const;

    DeviceLink& link_;
    QVBoxLayout* column_;
    std::vector<Row> rows_;
};

} // namespace tactum
