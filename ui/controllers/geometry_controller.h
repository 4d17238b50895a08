// Shapes that another program has changed, with the feel that the scene has.
#pragma once

#include <filesystem>

#include <QDialog>
#include <QObject>
#include <QPointer>

#include "ui/controllers/workbench.h"

namespace tactum {

struct GeometryUpdate;

/// Thread: ui.
class GeometryController : public QObject {
    Q_OBJECT
public:
    explicit GeometryController(const Workbench& bench);

private:
    void askForFile();
    void update(const std::filesystem::path& file);
    void offer();
    void show(const GeometryUpdate& update);

    Workbench bench_;
    QPointer<QDialog> list_; ///< what is not as before
};

} // namespace tactum
