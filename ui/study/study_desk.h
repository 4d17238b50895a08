// The study that an author is making: its conditions are states of the scene, kept under names.
#pragma once

#include <functional>

#include <QObject>

#include "core/study/study_file.h"
#include "ui/base/background_job.h"

namespace tactum {

class Document;

/// Thread: ui. Files are read and written on a worker.
class StudyDesk : public QObject {
    Q_OBJECT
public:
    explicit StudyDesk(Document& document, QObject* parent = nullptr);

    const Study& study() const { return study_; }
    const QString& file() const { return file_; } ///< empty: it was not saved yet
    bool modified() const { return modified_; }
    bool working() const { return job_.running(); }

    void begin();
    void setDesign(StudyDesign design);
    /// The scene as it is now becomes a condition. False, and nothing changes, where the name is taken or
    /// empty, or there are as many as there may be.
    bool keep(const QString& name);
    /// The condition becomes the scene as it is now.
    void replace(int condition);
    bool rename(int condition, const QString& name);
    void remove(int condition);
    /// The scene becomes the condition, as one step of the history.
    void show(int condition);

    /// Ends with changed(), or failed().
    void open(const QString& file);
    /// The same; then `after` where it is written.
    void save(const QString& file, std::function<void()> after = {});

signals:
    void changed();
    /// One line for the person.
    void failed(const QString& sentence);

private:
    bool isFree(const QString& name) const;
    void edited();

    Document& document_;
    Study study_;
    QString file_;
    bool modified_ = false;
    int edits_ = 0; ///< so far
    BackgroundJob job_;
};

} // namespace tactum
