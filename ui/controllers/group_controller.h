// Groups: made of the selected objects, taken apart, and selected as a whole.
#pragma once

#include <QObject>

#include "core/scene/scene.h"
#include "ui/controllers/workbench.h"

namespace tactum {

/// Its commands, and a double click on an object with a tool that selects. Thread: ui.
class GroupController : public QObject {
    Q_OBJECT
public:
    explicit GroupController(const Workbench& bench);

private:
    bool isAny(const std::vector<ObjectId>& objects) const;
    bool selectGroupOf(ObjectId object);

    Workbench bench_;
};

} // namespace tactum
