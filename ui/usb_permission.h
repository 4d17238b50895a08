// Lets the person's own account use haptic devices on the USB bus: a rule for udev, put where udev looks.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>

namespace tactum {

/// The rule that comes with the program; empty when it was not installed with it.
QString udevRule();
/// The one line that a person can run instead.
QString udevCommand(const QString& rule);

/// Asks the system for an administrator's consent. Thread: ui; the asking takes as long as the person does.
class UsbPermission : public QObject {
    Q_OBJECT
public:
    explicit UsbPermission(QObject* parent = nullptr);

    void ask();

signals:
    /// The rule is there. Devices that are plugged in have to be plugged in anew where udev did not reload.
    void granted();
    /// It could not be done from here: the sentence says why, the line does it.
    void refused(const QString& sentence, const QString& command);

private:
    void finish(int code, QProcess::ExitStatus status);

    bool asking_ = false;
};

} // namespace tactum
