// Where samples are heard.
#pragma once

#include <memory>
#include <span>

#include <QString>

class QAudioSink;
class QIODevice;

namespace tactum {

/// Mono, 48 kHz. Never waits: what the system has no room for is left out, and when nothing comes it is
/// silent. Thread: ui.
class SoundOutput {
public:
    SoundOutput();
    ~SoundOutput();

    /// Why nothing can be heard on this machine; empty when it can.
    static QString whyNot();

    /// False when the system does not open its device after all.
    bool start();
    void stop();
    bool playing() const { return device_ != nullptr; }
    /// From -1 to 1.
    void play(std::span<const float> samples);

private:
    std::unique_ptr<QAudioSink> sink_;
    QIODevice* device_ = nullptr; ///< of the sink
};

} // namespace tactum
