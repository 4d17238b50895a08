// The dock "Study": the states of the scene that are its conditions, and what the study comes to.
#pragma once

#include <QWidget>

#include "core/study/design.h"

class QLabel;
class QPushButton;
class QTreeWidgetItem;

namespace tactum {

class HintedTree;
class StudyDesk;

/// Thread: ui.
class StudyPanel : public QWidget {
    Q_OBJECT
public:
    explicit StudyPanel(StudyDesk& desk, QWidget* parent = nullptr);

    /// The chosen condition; -1: none.
    int chosen() const;
    /// Whether there is a scene that could be kept.
    void setSceneThere(bool there);

signals:
    void keepAsked();
    void replaceAsked();
    void showAsked();
    void removeAsked();
    void editAsked();
    void runAsked();
    void chosenChanged();

private:
    QPushButton* addButton(const QString& text, const char* name, const QString& meaning,
                           void (StudyPanel::*asked)());
    void refresh();
    void rename(QTreeWidgetItem* item);
    void showChosen();

    StudyDesk& desk_;
    HintedTree* list_;
    QLabel* summary_;
    QPushButton *keep_, *replace_, *show_, *remove_, *edit_, *run_;
    bool filling_ = false;
};

/// What a study comes to, a line each: procedure, trials, time, and what keeps it from being run.
QString summaryOf(const StudyDesign& design);
/// About so long, in s: 4 s for each interval without a limit, 3 s for each answer.
double expectedSeconds(const StudyDesign& design);

} // namespace tactum
