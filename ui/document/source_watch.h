// Watches the file that the model is from, and says when another program has written it.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "ui/document/document.h"

namespace tactum {

/// Tells each version of the file once, when nobody has written on it for a moment. A file that was replaced
/// or comes back is noticed too, for its folder is watched. Thread: ui.
class SourceWatch : public QObject {
    Q_OBJECT
public:
    explicit SourceWatch(Document& document, QObject* parent = nullptr);

signals:
    void changed();

private:
    void follow();
    void look();

    Document& document_;
    QFileSystemWatcher watcher_;
    QTimer settling_;
    FileStamp seen_, told_;
};

} // namespace tactum
