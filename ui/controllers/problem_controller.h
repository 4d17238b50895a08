// The list of problems and the view: where they are, and how far repairing them is.
#pragma once

#include <QObject>

#include "core/scene/scene.h"
#include "ui/controllers/workbench.h"

namespace tactum {

class Problems;
struct Problem;

/// Thread: ui.
class ProblemController : public QObject {
    Q_OBJECT
public:
    ProblemController(const Workbench& bench, Problems& problems);

private:
    void showPlace(ObjectId id, const Problem& problem);

    Workbench bench_;
};

} // namespace tactum
