// Over the top of the view: scenes of runs that died, each with what to do about it. Never modal.
#pragma once

#include <set>

#include <QWidget>

class QVBoxLayout;

namespace tactum {

class Recovery;
struct LostScene;

/// A line for each scene; hidden when there is none. Thread: ui.
class RecoveryBar : public QWidget {
    Q_OBJECT
public:
    explicit RecoveryBar(Recovery& recovery, QWidget* parent = nullptr);

signals:
    /// Index into Recovery::scenes(). Whoever hears it sees to what is unsaved now.
    void recoverAsked(std::size_t index);

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void refresh();
    QWidget* makeLine(std::size_t index);
    void addChoices(QWidget& line, std::size_t index);

    Recovery& recovery_;
    QVBoxLayout* lines_;
    bool later_ = false; ///< the person does not want to be asked now
};

} // namespace tactum
