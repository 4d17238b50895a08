// Lets the person's own account use haptic devices: a rule for udev and limits for real time, put where the
// system looks for them.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>

namespace tactum {

/// The rule that comes with the program; empty when it was not installed with it.
QString udevRule();
/// The one line that a person can run instead.
QString permitCommand(const QString& rule);
/// Whether this account lacks the priority that the loops ask for, and its limits were not put there yet:
/// they count from the next login on. Thread: ui.
bool lacksRealTime();

/// Asks the system for an administrator's consent. Thread: ui; the asking takes as long as the person does.
class UsbPermission : public QObject {
    Q_OBJECT
public:
    explicit UsbPermission(QObject* parent = nullptr);

    void ask();

signals:
    /// Rule and limits are there. Devices that are plugged in have to be plugged in anew where udev did not
    /// reload.
    void granted();
    /// It could not be done from here: the sentence says why, the line does it.
    void refused(const QString& sentence, const QString& command);

private:
    void finish(int code, QProcess::ExitStatus status);

    bool asking_ = false;
};

} // namespace tactum
