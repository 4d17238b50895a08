// The page "Live" of the dock Device: where the handle is, what it gets and what its motors bear.
#pragma once

#include <QWidget>

class QLabel;
class QComboBox;

namespace tactum {

class ButtonLamps;
class Engine;
class ForceMeter;
class LevelBar;
class WorkspacePicture;

/// Thread: ui.
class DeviceLive : public QWidget {
    Q_OBJECT
public:
    explicit DeviceLive(QWidget* parent = nullptr);

    /// Once a frame while it is visible.
    void display(const Engine& engine);
    /// Which of `count` buttons ends all force, as a bit; 0: none. `possible`: the device can be stopped so.
    void setStopButton(std::uint32_t button, int count, bool possible);
    /// Whether the whole hand holds it. `possible`: a hand holds it at all.
    void setGrasped(bool grasped, bool possible);

signals:
    void stopButtonChosen(std::uint32_t button);
    void graspChosen(bool grasped);

private:
    void addChoice(const QString& words, QComboBox* box);
    QLabel* addRow(const QString& word, const char* name, const QString& meaning);

    WorkspacePicture* picture_;
    QLabel *position_, *rate_, *heat_;
    ForceMeter* force_;
    LevelBar* heatBar_;
    ButtonLamps* lamps_;
    QLabel* lampWord_;
    QLabel* trouble_;
    QComboBox *grip_, *stop_;
    int frames_ = 0;
};

} // namespace tactum
