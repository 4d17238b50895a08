#include "tests/core/loop/message_bus.h"

#include <csignal>
#include <sched.h>
#include <sys/wait.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

namespace tactum::test {
namespace {

constexpr const char* kConfiguration =
    "<!DOCTYPE busconfig PUBLIC \"-//freedesktop//DTD D-Bus Bus Configuration 1.0//EN\" "
    "\"http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd\">"
    "<busconfig><listen>unix:path=%1/bus</listen><auth>EXTERNAL</auth><policy context=\"default\">"
    "<allow user=\"*\"/><allow own=\"*\"/><allow send_destination=\"*\"/><allow receive_sender=\"*\"/>"
    "</policy></busconfig>";

int refuse(sd_bus_error* error, const char* why) {
    return sd_bus_error_set_const(error, "org.freedesktop.DBus.Error.AccessDenied", why);
}

/// By /proc, as rtkit looks: prlimit() of another account's process is not everywhere allowed.
bool limitedTo(std::uint64_t process, long most) {
    QFile limits(QString("/proc/%1/limits").arg(process));
    if (!limits.open(QIODevice::ReadOnly)) return false;
    for (const QByteArray& line : limits.readAll().split('\n'))
        if (line.startsWith("Max realtime timeout")) {
            const QList<QByteArray> columns = line.simplified().split(' '); // soft, hard, unit at the end
            bool number = false;
            const long hard = columns.at(columns.size() - 2).toLong(&number);
            return number && hard <= most;
        }
    return false;
}

int makeRealtime(sd_bus_message* call, void* of, sd_bus_error* error) {
    const auto& manners = *static_cast<const BrokerManners*>(of);
    std::uint64_t process = 0, thread = 0;
    std::uint32_t priority = 0;
    if (sd_bus_message_read(call, "ttu", &process, &thread, &priority) < 0) return -EINVAL;
    if (!manners.answers) return 1; // taken, and never heard of again
    if (manners.refuses) return refuse(error, "not authorized");
    if (!limitedTo(process, manners.timeMax)) return refuse(error, "RLIMIT_RTTIME is not set");
    if (priority < 1 || int(priority) > manners.highest) return refuse(error, "the priority is too high");
    const sched_param parameters{.sched_priority = int(priority)};
    if (sched_setscheduler(pid_t(thread), SCHED_RR | SCHED_RESET_ON_FORK, &parameters) != 0) return -errno;
    return sd_bus_reply_method_return(call, "");
}

int timeMax(sd_bus*, const char*, const char*, const char*, sd_bus_message* reply, void* of, sd_bus_error*) {
    return sd_bus_message_append(reply, "x", std::int64_t(static_cast<const BrokerManners*>(of)->timeMax));
}

int highest(sd_bus*, const char*, const char*, const char*, sd_bus_message* reply, void* of, sd_bus_error*) {
    return sd_bus_message_append(reply, "i", static_cast<const BrokerManners*>(of)->highest);
}

const sd_bus_vtable kService[] = {
    SD_BUS_VTABLE_START(0),
    SD_BUS_METHOD("MakeThreadRealtimeWithPID", "ttu", "", makeRealtime, SD_BUS_VTABLE_UNPRIVILEGED),
    SD_BUS_PROPERTY("RTTimeUSecMax", "x", timeMax, 0, 0),
    SD_BUS_PROPERTY("MaxRealtimePriority", "i", highest, 0, 0), SD_BUS_VTABLE_END};

/// Says by a byte that it is there.
[[noreturn]] void serve(const QByteArray& address, BrokerManners manners, int ready) {
    sd_bus* bus = nullptr;
    sd_bus_new(&bus);
    sd_bus_set_address(bus, address.constData());
    sd_bus_set_bus_client(bus, 1);
    if (sd_bus_start(bus) < 0 ||
        sd_bus_add_object_vtable(bus, nullptr, manners.path, manners.interface, kService, &manners) < 0 ||
        sd_bus_request_name(bus, manners.name, 0) < 0)
        _exit(1);
    if (write(ready, "r", 1) != 1) _exit(1);
    for (;;)
        if (sd_bus_process(bus, nullptr) == 0) sd_bus_wait(bus, UINT64_MAX);
}

} // namespace

MessageBus::MessageBus() {
    QFile configuration(folder_.filePath("bus.conf"));
    if (!configuration.open(QIODevice::WriteOnly)) return;
    configuration.write(QString(kConfiguration).arg(folder_.path()).toUtf8());
    configuration.close();
    QFile::setPermissions(folder_.path(),
                          QFile::permissions(folder_.path()) | QFile::ReadOther | QFile::ExeOther);
    daemon_.start("dbus-daemon",
                  {"--nofork", "--print-address", "--config-file=" + configuration.fileName()});
    if (daemon_.waitForStarted() && daemon_.waitForReadyRead()) address_ = daemon_.readLine().trimmed();
}

MessageBus::~MessageBus() {
    daemon_.kill();
    daemon_.waitForFinished();
}

PriorityService::PriorityService(const MessageBus& bus, const BrokerManners& manners) {
    int ends[2];
    if (pipe(ends) != 0) return;
    process_ = fork();
    if (process_ == 0) serve(bus.address(), manners, ends[1]);
    close(ends[1]);
    char byte = 0;
    ready_ = read(ends[0], &byte, 1) == 1;
    close(ends[0]);
}

PriorityService::~PriorityService() {
    if (process_ > 0) kill(process_, SIGKILL);
    if (process_ > 0) waitpid(process_, nullptr, 0);
}

} // namespace tactum::test
