// A report of the scene, as a page or as a printed one.
#pragma once

#include <QObject>
#include <QStringList>

#include "ui/controllers/workbench.h"

namespace tactum {

class GuardWatch;

/// Thread: ui; written on a worker.
class ReportController : public QObject {
    Q_OBJECT
public:
    /// `samples`: files beside which nothing is written.
    ReportController(const Workbench& bench, const GuardWatch& guard, const QStringList& samples);

private:
    void ask();
    void write(const QString& file);

    Workbench bench_;
    const GuardWatch& guard_;
    QStringList samples_;
};

} // namespace tactum
