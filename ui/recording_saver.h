// Writes the flight recorder's last minute to a file: when the person wants it, and by itself after a fault.
#pragma once

#include <QObject>
#include <QTimer>

#include "core/runtime/engine.h"
#include "ui/background_job.h"
#include "ui/document.h"

namespace tactum {

/// Whether a file is a recording, by its ending.
bool isRecording(const QString& file);

/// Thread: ui. The rows are copied here, in some ten milliseconds; the file is made on a worker and is there
/// whole or not at all.
class RecordingSaver : public QObject {
    Q_OBJECT
public:
    RecordingSaver(const Engine& engine, const Document& document, QObject* parent = nullptr);

    /// Once a frame: a second after a fault its recording is saved into folder().
    void watch();
    void save(const QString& file, const QString& reason);
    bool saving() const { return job_.running(); }

    /// Where recordings of faults are kept, the last twenty of them.
    static QString folder();

signals:
    /// `afterFault`: nobody had asked for it.
    void saved(const QString& file, bool afterFault);
    void failed(const QString& sentence);

private:
    void saveFault();
    void write(const QString& file, const QString& reason, bool afterFault);

    const Engine& engine_;
    const Document& document_;
    std::uint64_t faults_ = 0;
    QString reason_; ///< of the newest fault
    QTimer due_;
    BackgroundJob job_;
};

} // namespace tactum
