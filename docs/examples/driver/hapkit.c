/* A driver for the Hapkit 3.0, Stanford's kit of one degree of freedom, as a plug-in of Tactum (docs/drivers.md).
 *
 *   cc -O2 -shared -fPIC -I/usr/include/tactum -Ihapkit hapkit.c -lm -o ~/.local/share/Tactum/drivers/hapkit.so
 *
 * It has no protocol of its maker's: its sketches feel a world that the board itself knows. So the board gets a
 * sketch of ours, hapkit/hapkit.ino, and both sides share hapkit/hapkit_wire.h. Its handle goes along x.
 * HAPKIT=/dev/ttyUSB0 names its port. Never tried with a real one. */
#include <fcntl.h>
#include <glob.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "hapkit_wire.h"
#include "tactum_driver.h"

enum { ASK_AGAIN = 5, SILENT = 100, PATIENCE_MS = 4000 }; /* ticks, ticks; a board that was reset needs two seconds */

typedef struct {
    int port;
    HapkitReader reader;
    int silent; /* ticks without an answer */
} Hapkit;

static int say(int port, double force) {
    uint8_t packet[HAPKIT_SIZE];
    hapkit_put(packet, HAPKIT_COMMAND, (int16_t)lround(1000 * force));
    return write(port, packet, sizeof packet) == (ssize_t)sizeof packet;
}

static void stop(void* device) {
    say(((Hapkit*)device)->port, 0);
}

static int32_t find(TactumFound* found, int32_t room) {
    const char* named = getenv("HAPKIT"); /* else whatever calls itself an Arduino; another is refused by open() */
    glob_t ports;
    int32_t count = 0;
    if (glob(named ? named : "/dev/serial/by-id/*Arduino*", 0, NULL, &ports) != 0) return 0;
    for (; count < room && count < (int32_t)ports.gl_pathc; ++count) {
        const TactumFigures figures = {.rate = 1000, .max_force = 3, .continuous_force = 1, /* assumed: it gets hot */
                                       .workspace_radius = 0.045, .delay = 2,
                                       .position_resolution = 1.3e-5}; /* 923 steps to half a turn of the pulley */
        snprintf(found[count].port, TACTUM_TEXT, "%s", ports.gl_pathv[count]);
        snprintf(found[count].name, TACTUM_TEXT, "Hapkit");
        if (access(ports.gl_pathv[count], R_OK | W_OK) != 0)
            snprintf(found[count].trouble, TACTUM_TEXT, "you may not use it: add yourself to the group dialout");
        found[count].figures = figures;
    }
    globfree(&ports);
    return count;
}

/* 1: something new; 0: nothing; -1: the port is gone. */
static int hear(Hapkit* device, double* place) {
    uint8_t bytes[64];
    int fresh = 0;
    ssize_t count;
    while ((count = read(device->port, bytes, sizeof bytes)) > 0)
        for (ssize_t i = 0; i < count; ++i) {
            int16_t said;
            if (!hapkit_take(&device->reader, HAPKIT_ANSWER, bytes[i], &said)) continue;
            *place = 1e-5 * said;
            fresh = 1;
        }
    return fresh ? 1 : count == 0 ? -1 : 0; /* a raw port that has nothing says -1, one that hung up says 0 */
}

static int answers(Hapkit* device) {
    const struct timespec millisecond = {0, 1000000};
    double place;
    for (int passed = 0; passed < PATIENCE_MS; ++passed) {
        if (passed % 100 == 0) stop(device);
        if (hear(device, &place) == 1) return 1;
        nanosleep(&millisecond, NULL);
    }
    return 0;
}

static void* open_port(const char* name, char* trouble) {
    struct termios raw;
    Hapkit* device = calloc(1, sizeof *device);
    device->port = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (device->port >= 0 && tcgetattr(device->port, &raw) == 0) {
        cfmakeraw(&raw);
        cfsetspeed(&raw, B500000);
        tcsetattr(device->port, TCSANOW, &raw);
        tcflush(device->port, TCIOFLUSH);
        if (answers(device)) {
            stop(device); /* the first question */
            return device;
        }
        snprintf(trouble, TACTUM_TEXT, "what is at %s does not run hapkit.ino.", name);
    } else {
        snprintf(trouble, TACTUM_TEXT, "its port %s cannot be used; plug it in again.", name);
    }
    if (device->port >= 0) close(device->port);
    free(device);
    return NULL;
}

static int32_t exchange(void* opened, const double* force, TactumReading* reading) {
    Hapkit* device = opened;
    const int fresh = hear(device, &reading->position[0]);
    device->silent = fresh == 1 ? 0 : device->silent + 1;
    if (fresh == 1)
        say(device->port, force[0]);
    else if (device->silent % ASK_AGAIN == 0)
        stop(device); /* an answer was lost: ask again */
    return fresh == 1 ? 1 : fresh < 0 || device->silent > SILENT ? -1 : 0;
}

static void close_port(void* opened) {
    stop(opened);
    tcdrain(((Hapkit*)opened)->port);
    close(((Hapkit*)opened)->port);
    free(opened);
}

const TactumDriver* tactum_driver(uint32_t abi) {
    static const TactumDriver driver = {.size = sizeof(TactumDriver), .find = find, .open = open_port, .exchange = exchange,
                                        .stop = stop, .close = close_port};
    return abi == TACTUM_DRIVER_ABI ? &driver : NULL;
}
