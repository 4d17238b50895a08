// What a participant sees of a study: one thing at a time, in large type, with its key. Never a name of a
// condition or a value.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QWidget>

#include "core/study/study_run.h"

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace tactum {

/// What the page has to know of the session besides the run.
struct StudyMoment {
    bool felt = false;    ///< the stimulus of this step is felt already
    bool lift = false;    ///< it waits until nothing is touched
    bool forces = true;   ///< they are on
    bool resting = false; ///< a pause that is not over

    bool operator==(const StudyMoment&) const = default;
};

/// Thread: ui.
class StudyPage : public QWidget {
    Q_OBJECT
public:
    explicit StudyPage(QWidget* parent = nullptr);

    void display(const StudyRun& run, const StudyMoment& moment);
    /// That is shown.
    const StudyMoment& moment() const { return moment_; }
    /// Whether the run is to end; Space goes on, E ends it.
    void askToEnd();
    void refuse(const QString& sentence);
    /// It leaves the view free: a stimulus that may be looked at. Else it lies over the whole view.
    bool leavesView() const { return leavesView_; }
    /// All words on it, for tests and screen readers.
    QString words() const;

signals:
    void proceeded();
    void againWanted();
    void chosen(int choice);
    void replied(const QString& words);
    void forcesWanted();
    void endWanted();
    void leavesViewChanged(bool leaves);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override; ///< Esc in the field

private:
    /// A button, and the key that does the same.
    struct Way {
        QString text;
        int key;
        std::function<void()> act;
    };
    void show(const QString& head, const QString& text, std::vector<Way> ways, bool leavesView = false);
    void showAgain();
    void showInstructions();
    void showStimulus();
    void showChoice();
    void showQuestion();
    void showRating(const StudyQuestion& question);
    void showField(const StudyQuestion& question);
    void showEnd();
    Way goOn(const QString& text);

    QLabel *head_, *text_, *low_, *high_, *note_;
    QLineEdit* field_;
    QHBoxLayout* buttons_;
    QWidget* scale_;
    std::vector<Way> ways_;
    std::vector<QPushButton*> shown_;
    std::optional<StudyRun> run_;
    StudyMoment moment_;
    bool ending_ = false, leavesView_ = false;
};

} // namespace tactum
