// Small pictures of the files opened last, kept in the cache folder.
#pragma once

#include <QImage>
#include <QObject>
#include <QStringList>

#include "core/scene/scene.h"
#include "ui/base/background_job.h"
#include "ui/document/document.h"

namespace tactum {

/// What is found of a file.
struct RecentLook {
    QString path;
    bool gone = false;
    bool changed = false; ///< it is another file than the picture was made of
    QImage picture;       ///< null where there is none
};

/// Pictures are drawn as those of a bundle are (previewOf()). Files and pictures are only looked at on a
/// worker: a folder that does not answer holds nobody up. Thread: ui.
class RecentPictures : public QObject {
    Q_OBJECT
public:
    explicit RecentPictures(QObject* parent = nullptr);

    /// Draws the scene of a file as it is now, and keeps the picture. Ends with kept().
    void keep(const Scene& scene, const FileStamp& file);
    /// Ends with looked(). The pictures of all other files go: there are never more than files here.
    void look(const QStringList& files);

signals:
    void kept();
    void looked(const QList<tactum::RecentLook>& files);

private:
    BackgroundJob drawing_, looking_;
};

} // namespace tactum
