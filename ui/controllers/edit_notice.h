// What the notice bar says of an edit, as long as that edit is the last one.
#pragma once

#include <QObject>
#include <QString>

namespace tactum {

class Document;
class NoticeBar;

/// Who tells of an edit shows it in the bar and keeps() the sentence: undone, it goes; after another edit
/// only what was also offered about it goes, for Undo would take that other one back. Thread: ui.
class EditNotice : public QObject {
    Q_OBJECT
public:
    EditNotice(Document& document, NoticeBar& notice, QObject* parent);

    /// Of the step of the history that has just been made.
    void keep(const QString& sentence);
    /// Of what made no step.
    void forget() { step_ = 0; }
    /// Whether the edit that was told of is the last one.
    bool isLast() const;

signals:
    void undone();

private:
    void follow(int step);

    Document& document_;
    NoticeBar& notice_;
    QString sentence_;
    int step_ = 0; ///< of the history, after the edit; 0: none is told of
};

} // namespace tactum
