// The files opened last, on the start page: their pictures are made when a scene was opened or saved.
#pragma once

#include <QObject>

#include "ui/controllers/workbench.h"

namespace tactum {

class RecentList;
class RecentPictures;

/// Thread: ui.
class RecentController : public QObject {
    Q_OBJECT
public:
    RecentController(const Workbench& bench, RecentList& list);

    /// Another file came, or one was forgotten.
    void show();

private:
    void keepPicture();

    Workbench bench_;
    RecentList& list_;
    RecentPictures* pictures_;
};

} // namespace tactum
