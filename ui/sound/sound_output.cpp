#include "ui/sound/sound_output.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QAudioDevice>
#include <QAudioSink>
#include <QMediaDevices>
#include <QObject>

#include "ui/sound/contact_sound.h"

namespace tactum {

namespace {

constexpr double kBuffer = 0.12; // s: some frames of the window, little enough to belong to what is seen

QAudioFormat format() {
    QAudioFormat f;
    f.setSampleRate(kSoundRate);
    f.setChannelCount(1);
    f.setSampleFormat(QAudioFormat::Int16);
    return f;
}

} // namespace

SoundOutput::SoundOutput() = default;

SoundOutput::~SoundOutput() {
    stop();
}

QString SoundOutput::whyNot() {
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (device.isNull()) return QObject::tr("This machine has no audio output");
    if (!device.isFormatSupported(format()))
        return QObject::tr("%1 does not play 16 bits at 48 kHz").arg(device.description());
    return {};
}

bool SoundOutput::start() {
    stop();
    if (!whyNot().isEmpty()) return false;
    sink_ = std::make_unique<QAudioSink>(format());
    sink_->setBufferSize(qsizetype(kBuffer * kSoundRate) * qsizetype(sizeof(qint16)));
    device_ = sink_->start();
    if (!device_ || sink_->error() != QAudio::NoError) stop();
    return device_ != nullptr;
}

void SoundOutput::stop() {
    if (sink_) sink_->stop();
    device_ = nullptr;
    sink_.reset();
}

void SoundOutput::play(std::span<const float> samples) {
    if (!device_) return;
    const std::size_t room = std::size_t(std::max<qsizetype>(0, sink_->bytesFree())) / sizeof(qint16);
    // What is newest is what is felt now.
    if (samples.size() > room) samples = samples.last(room);
    std::vector<qint16> words(samples.size());
    std::ranges::transform(samples, words.begin(),
                           [](float s) { return qint16(std::lround(32767 * std::clamp(s, -1.0f, 1.0f))); });
    device_->write(reinterpret_cast<const char*>(words.data()), qint64(words.size() * sizeof(qint16)));
}

} // namespace tactum
