// What is done in the window changes something, in words: the figures of the scene's file, the selection,
// where the view looks from and what it shows, which commands are on, what is said and kept, and which window
// came.
#pragma once

#include <functional>
#include <vector>

#include <QTimer>

#include "tests/ui/window/window_fixture.h"

class QDialog;

namespace tactum {

/// Does one thing after the other and writes down what differs afterwards. Windows that come are told and
/// closed again; edits are undone.
class WindowEffects {
public:
    /// `prepare` is done before each: what is selected.
    WindowEffects(TouchedWindow& program, std::function<void()> prepare);
    /// `caughtUp`: true when the engine has what was edited.
    WindowEffects(MainWindow& window, Document& document, std::function<bool()> caughtUp,
                  std::function<void()> prepare);

    void note(const QString& words, const std::function<void()>& act);
    /// A command, unless it is off; a switch is switched back.
    void choose(const char* id);
    /// The next dialog that keeps everything else waiting is answered so, instead of being closed.
    void answerNext(std::function<void(QDialog&)> answer) { answer_ = std::move(answer); }
    const QString& text() const { return text_; }

private:
    QStringList state();
    void settle();
    void closeWindows();
    void tellOf(QWidget& window);

    MainWindow& window_;
    Document& document_;
    bool onScreen_; ///< else it depends on the display who has the keys
    std::function<bool()> caughtUp_;
    std::function<void()> prepare_;
    std::vector<QAction*> actions_; ///< in the order of the table
    QTimer closing_;                ///< of dialogs that keep everything else waiting
    std::function<void(QDialog&)> answer_;
    QStringList windows_;
    QString text_;
};

} // namespace tactum
