#include "ui/engine/usb_permission.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/loop/urgency.h"

namespace tactum {

namespace {

/// For a shell, which gets the rule as its first argument, the number of the account and the file of its
/// limits. An account by its number: names may have characters in them that the file cannot hold.
constexpr const char* kScript =
    "install -m 644 -- \"$1\" /etc/udev/rules.d/70-tactum.rules && "
    "printf \":$2 - %s\\n\" \"rtprio 90\" \"nice -15\" \"memlock unlimited\" >\"$3\" && chmod 644 \"$3\" && "
    "udevadm control --reload && udevadm trigger --subsystem-match=usb --subsystem-match=tty "
    "--subsystem-match=hidraw --subsystem-match=misc";

/// Whose account it is, as the system counts.
QString account() {
    return QString::number(QFileInfo(QStringLiteral("/proc/self")).ownerId());
}

/// By pam_limits(8), from the next login on.
QString limitsFile() {
    return QStringLiteral("/etc/security/limits.d/tactum-%1.conf").arg(account());
}

QString quoted(QString path) {
    return u'\'' + path.replace(u'\'', QStringLiteral("'\\''")) + u'\'';
}

} // namespace

QString udevRule() {
    const QString program = QCoreApplication::applicationDirPath();
    for (const QString& folder :
         {program + QStringLiteral("/../share/tactum"), program + QStringLiteral("/../../share/tactum"),
          QStringLiteral(TACTUM_RESOURCES)})
        if (const QFileInfo rule(folder + QStringLiteral("/udev/70-tactum.rules")); rule.exists())
            return rule.canonicalFilePath();
    return {};
}

QString permitCommand(const QString& rule) {
    return QStringLiteral("sudo sh -c '%1' sh %2 %3 %4")
        .arg(QString::fromLatin1(kScript), quoted(rule), account(), limitsFile());
}

bool lacksRealTime() {
    return !mayHavePriority(kServoPriority) && !QFileInfo::exists(limitsFile());
}

UsbPermission::UsbPermission(QObject* parent) : QObject(parent) {}

void UsbPermission::ask() {
    if (asking_) return;
    const QString rule = udevRule();
    if (rule.isEmpty())
        return emit refused(tr("The rule 70-tactum.rules was not installed with the program: install the "
                               "program anew."),
                            {});
    const QString asker = QStandardPaths::findExecutable(QStringLiteral("pkexec"));
    if (asker.isEmpty())
        return emit refused(tr("Run this line in a terminal, then plug the device in anew:"),
                            permitCommand(rule));
    asking_ = true;
    // Nobody's child: who is asked for a password may go on answering when the window is closed, and what
    // runs as root could not be ended from here.
    auto* process = new QProcess;
    connect(process, &QProcess::finished, process, &QObject::deleteLater);
    connect(process, &QProcess::finished, this, &UsbPermission::finish);
    process->start(asker, {QStringLiteral("/bin/sh"), QStringLiteral("-c"), QString::fromLatin1(kScript),
                           QStringLiteral("sh"), rule, account(), limitsFile()});
}

void UsbPermission::finish(int code, QProcess::ExitStatus status) {
    asking_ = false;
    if (status == QProcess::NormalExit && code == 0) return emit granted();
    emit refused(
        tr("The system did not allow it. Run this line in a terminal, then plug the device in anew:"),
        permitCommand(udevRule()));
}

} // namespace tactum
