// A message bus of the test's own, and on it a service that gives priority as RealtimeKit says that it does.
#pragma once

#include <QProcess>
#include <QTemporaryDir>

namespace tactum::test {

/// dbus-daemon, open to every account.
class MessageBus {
public:
    /// Empty address where there is no dbus-daemon.
    MessageBus();
    ~MessageBus();
    const QByteArray& address() const { return address_; }

private:
    QTemporaryDir folder_;
    QProcess daemon_;
    QByteArray address_;
};

/// How the service behaves.
struct BrokerManners {
    const char* name = "org.freedesktop.RealtimeKit1";
    const char* path = "/org/freedesktop/RealtimeKit1";
    const char* interface = "org.freedesktop.RealtimeKit1";
    int highest = 20;       ///< MaxRealtimePriority
    bool refuses = false;   ///< as the policy kit does for an account without a seat
    bool answers = true;    ///< to calls
    long timeMax = 200'000; ///< us, RTTimeUSecMax
};

inline const BrokerManners kPortalManners{.name = "org.freedesktop.portal.Desktop",
                                          .path = "/org/freedesktop/portal/desktop",
                                          .interface = "org.freedesktop.portal.Realtime"};

/// In a process of its own, with the rights of this one, until it is destroyed. By RealtimeKit's README and
/// its sources' order of checks (rtkit 0.13): a thread of a process whose RLIMIT_RTTIME is above the limit,
/// or that asks for more than the highest priority, is refused; else it runs under SCHED_RR and resets on
/// fork.
class PriorityService {
public:
    PriorityService(const MessageBus& bus, const BrokerManners& manners);
    ~PriorityService();
    bool ready() const { return ready_; }

private:
    pid_t process_ = -1;
    bool ready_ = false;
};

} // namespace tactum::test
