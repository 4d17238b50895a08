#include "ui/controllers/recent_controller.h"

#include "ui/document/document.h"
#include "ui/document/recent_files.h"
#include "ui/document/recent_pictures.h"
#include "ui/panels/recent_list.h"

namespace tactum {

RecentController::RecentController(const Workbench& bench, RecentList& list)
    : QObject(&bench.window), bench_(bench), list_(list), pictures_(new RecentPictures(this)) {
    connect(&bench.document, &Document::opened, this, &RecentController::keepPicture);
    connect(&bench.document, &Document::saved, this, &RecentController::keepPicture);
    connect(pictures_, &RecentPictures::kept, this, &RecentController::show);
    connect(pictures_, &RecentPictures::looked, &list, &RecentList::setLooks);
    connect(&list, &RecentList::removeAsked, this, [this](const QString& file) {
        forgetFile(file);
        show();
    });
    show();
}

void RecentController::show() {
    const QList<RecentFile> files = recentlyOpened();
    list_.setFiles(files);
    QStringList paths;
    for (const RecentFile& file : files)
        paths << file.path;
    pictures_->look(paths);
}

void RecentController::keepPicture() {
    if (!bench_.document.modified() && bench_.document.stamp().bytes > 0)
        pictures_->keep(bench_.document.scene(), bench_.document.stamp());
}

} // namespace tactum
