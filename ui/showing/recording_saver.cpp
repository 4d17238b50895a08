#include "ui/showing/recording_saver.h"

#include <QDateTime>
#include <QDir>
#include <QStandardPaths>

#include "core/base/atomic_file.h"
#include "core/safety/inhibit_words.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

constexpr int kAftermath = 1000; // ms, that are recorded after a fault
constexpr int kKept = 20;        // recordings of faults

QString pattern() {
    return QStringLiteral("*.") + asIs(kRecordingEnding);
}

void dropOldest(const QString& folder) {
    const QDir dir(folder);
    const QStringList files = dir.entryList({pattern()}, QDir::Files, QDir::Time);
    for (const QString& file : files.mid(kKept))
        QFile::remove(dir.filePath(file));
}

} // namespace

bool isRecording(const QString& file) {
    return file.endsWith(pattern().mid(1), Qt::CaseInsensitive);
}

RecordingSaver::RecordingSaver(Engine& engine, const Document& document, QObject* parent)
    : QObject(parent), engine_(engine), hands_(engine), document_(document) {
    for (std::size_t hand = 0; hand < hands_.count(); ++hand)
        faults_.push_back(hands_.servo(hand).faults);
    due_.setSingleShot(true);
    due_.setInterval(kAftermath);
    connect(&due_, &QTimer::timeout, this, &RecordingSaver::saveFault);
    connect(&job_, &BackgroundJob::finished, this, [this] {
        if (waiting_.empty()) return;
        const Order next = waiting_.front();
        waiting_.pop_front();
        write(next);
    });
}

QString RecordingSaver::folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/recordings");
}

void RecordingSaver::watch() {
    faults_.resize(hands_.count());
    for (std::size_t hand = 0; hand < faults_.size(); ++hand) {
        const ServoTelemetry& servo = hands_.servo(hand);
        if (servo.faults > faults_[hand]) {
            if (isFault(servo.inhibit)) reason_ = wordsOf(inhibitWords(servo.inhibit).brief);
            if (!due_.isActive()) due_.start();
        }
        faults_[hand] = servo.faults;
    }
}

void RecordingSaver::flush() {
    bool hangs = false;
    for (std::size_t hand = 0; hand < hands_.count(); ++hand)
        hangs = hangs || hands_.servoStandsStill(hand) ||
                (engine_.running() && hands_.servo(hand).inhibit == InhibitReason::Stall);
    if (hangs) reason_ = wordsOf(inhibitWords(InhibitReason::Stall).brief);
    if (!due_.isActive() && !hangs) return;
    due_.stop();
    saveFault();
}

void RecordingSaver::saveFault() {
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH-mm-ss"));
    QDir().mkpath(folder());
    if (const Taken recording = take(tr("Fault: %1").arg(reason_)))
        write({folder() + u'/' + name + pattern().mid(1), recording, true});
}

void RecordingSaver::save(const QString& file, const Taken& recording) {
    write({file, recording, false});
}

RecordingSaver::Taken RecordingSaver::take(const QString& reason) {
    auto recording = std::make_shared<Recording>();
    recording->run = engine_.recorded();
    recording->reason = reason.toStdString();
    if (!document_.path().empty()) recording->sources.push_back(std::filesystem::absolute(document_.path()));
    if (!recording->run.servo.rows.empty() || !recording->run.proxy.rows.empty()) return recording;
    emit failed(tr("Nothing was recorded yet: the device has not run. Start it first."));
    return {};
}

RecordingSaver::~RecordingSaver() {
    for (const Order& order : waiting_)
        (void)put(order); // there is no window left to say it in
}

Result<void> RecordingSaver::put(const Order& order) {
    Result<void> written = writeFileAtomically(order.file.toStdString(), recordingBytes(*order.recording), 0);
    if (order.afterFault) dropOldest(folder());
    return written;
}

/// One after the other.
void RecordingSaver::write(const Order& order) {
    if (job_.running()) return waiting_.push_back(order);
    job_.start([this, order](const Progress&) -> BackgroundJob::Delivery {
        return [this, written = put(order), order] {
            if (written)
                emit saved(order.file, order.afterFault);
            else
                emit failed(QString::fromStdString(written.error().text));
        };
    });
}

} // namespace tactum
