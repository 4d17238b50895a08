// Writes the flight recorder's last minute to a file: when the person wants it, and by itself after a fault.
#pragma once

#include <deque>
#include <vector>

#include <QObject>
#include <QTimer>

#include "core/recording/recording_file.h"
#include "core/runtime/hands.h"
#include "ui/base/background_job.h"
#include "ui/document/document.h"

namespace tactum {

/// Whether a file is a recording, by its ending.
bool isRecording(const QString& file);

/// Thread: ui. The rows are copied here, in some ten milliseconds; the file is made on a worker and is there
/// whole or not at all.
class RecordingSaver : public QObject {
    Q_OBJECT
public:
    RecordingSaver(Engine& engine, const Document& document, QObject* parent = nullptr);
    /// Writes what still waits for its turn.
    ~RecordingSaver() override;

    using Taken = std::shared_ptr<const Recording>;

    /// Once a frame: a second after a fault its recording is saved into folder().
    void watch();
    /// A fault that is not saved yet, or a device that hangs or does not answer, is saved now: the recorder
    /// is about to go, with device or program.
    void flush();
    /// The last minute as it is now; nothing, and failed(), when there is none.
    Taken take(const QString& reason);
    void save(const QString& file, const Taken& recording);
    bool saving() const { return job_.running(); }

    /// Where recordings of faults are kept, the last twenty of them.
    static QString folder();

signals:
    /// `afterFault`: nobody had asked for it.
    void saved(const QString& file, bool afterFault);
    void failed(const QString& sentence);

private:
    void saveFault();
    struct Order {
        QString file;
        Taken recording;
        bool afterFault;
    };
    void write(const Order& order);
    static Result<void> put(const Order& order);

    Engine& engine_;
    Hands hands_;
    const Document& document_;
    std::vector<std::uint64_t> faults_; ///< of each hand
    QString reason_;                    ///< of the newest fault
    QTimer due_;
    std::deque<Order> waiting_;
    BackgroundJob job_;
};

} // namespace tactum
