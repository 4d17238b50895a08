/* A driver for the Haply 2DIY, the pantograph to build oneself, as a plug-in of Tactum (docs/drivers.md).
 *
 *   cc -O2 -shared -fPIC -I/usr/include/tactum haply_2diy.c -lm -o ~/.local/share/Tactum/drivers/haply_2diy.so
 *
 * What its board understands is said by Haply's hAPI: a byte for the kind, one for the device, then bytes and little-
 * endian floats. The board answers torques with the angles of its encoders. Never tried with a real one. */
#include <fcntl.h>
#include <glob.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include "tactum_driver.h"

enum { RESET = 0, SET_UP = 1, TORQUES = 2, BOARD = 5 };
static const double kInner = 0.07, kOuter = 0.09, kApart = 0.038; /* m: links, and from motor to motor (version 3) */
static const double kMiddle = 0.13;                               /* m, of the workspace, in front of the motors */
static const float kMostTorque = 0.12F;                           /* N m */

typedef struct {
    int port;
    double angle[2]; /* rad: of the left motor, which is the board's second, and of the right one */
    unsigned char answer[9];
    size_t got;
    int silent; /* ticks without an answer */
} Pantograph;

static int send_to(int port, unsigned char kind, const void* bytes, size_t count) {
    unsigned char packet[32] = {kind, BOARD};
    memcpy(packet + 2, bytes, count);
    return write(port, packet, 2 + count) == (ssize_t)(2 + count);
}

static void stop(void* device) {
    const float none[2] = {0, 0};
    send_to(((Pantograph*)device)->port, TORQUES, none, sizeof none);
}

static int32_t find(TactumFound* found, int32_t room) {
    const char* named = getenv("HAPLY_2DIY"); /* a port of its own, or what looks like one of Haply's boards */
    glob_t ports;
    int32_t count = 0;
    if (glob(named ? named : "/dev/serial/by-id/*Haply*M[0-9]*", 0, NULL, &ports) != 0) return 0;
    for (; count < room && count < (int32_t)ports.gl_pathc; ++count) {
        const TactumFigures figures = {.rate = 1000, .max_force = 0.8, .workspace_radius = 0.04, .delay = 2,
                                       .position_resolution = 1e-4}; /* 4,880 counts a turn, at 0.09 m */
        snprintf(found[count].port, TACTUM_TEXT, "%s", ports.gl_pathv[count]);
        snprintf(found[count].name, TACTUM_TEXT, "Haply 2DIY");
        if (access(ports.gl_pathv[count], R_OK | W_OK) != 0)
            snprintf(found[count].trouble, TACTUM_TEXT, "you may not use it: add yourself to the group dialout");
        found[count].figures = figures;
    }
    globfree(&ports);
    return count;
}

static void* open_port(const char* name, char* trouble) {
    struct termios raw;
    /* motors 1 and 2 at ports 2 and 1, all counter-clockwise; then no sensors, no outputs, and for each encoder in the
     * order of the ports the angle at rest (degrees) and its counts */
    const unsigned char wiring[] = {3, 1, 1, 3, 1, 1, 0, 0};
    const float encoders[] = {12, 4880, 168, 4880};
    unsigned char set_up[sizeof wiring + sizeof encoders];
    Pantograph* device = calloc(1, sizeof *device);
    memcpy(set_up, wiring, sizeof wiring);
    memcpy(set_up + sizeof wiring, encoders, sizeof encoders);
    device->port = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (device->port >= 0 && tcgetattr(device->port, &raw) == 0) {
        cfmakeraw(&raw);
        tcsetattr(device->port, TCSANOW, &raw);
        tcflush(device->port, TCIOFLUSH);
        if (send_to(device->port, RESET, NULL, 0) && send_to(device->port, SET_UP, set_up, sizeof set_up)) {
            stop(device); /* the first question */
            return device;
        }
    }
    snprintf(trouble, TACTUM_TEXT, "its port %s cannot be used; plug it in again.", name);
    if (device->port >= 0) close(device->port);
    free(device);
    return NULL;
}

/* Where the handle is (x, y from the left motor, y away from both), and the way to it from each elbow. */
static void kinematics(const double angle[2], double handle[2], double rod[2][2]) {
    const double a[2] = {kInner * cos(angle[0]), kInner * sin(angle[0])};
    const double b[2] = {kApart + kInner * cos(angle[1]), kInner * sin(angle[1])};
    const double half[2] = {(b[0] - a[0]) / 2, (b[1] - a[1]) / 2}, h = hypot(half[0], half[1]);
    const double up = sqrt(fmax(kOuter * kOuter - h * h, 0)) / fmax(h, 1e-9);
    for (int i = 0; i < 2; ++i) {
        const double across = up * (i == 0 ? -half[1] : half[0]);
        handle[i] = a[i] + half[i] + across;
        rod[0][i] = half[i] + across;
        rod[1][i] = -half[i] + across;
    }
}

/* By virtual work: the rods carry the force, p rod_0 + q rod_1 = f, and each motor holds its own at the elbow. */
static void torques(const double angle[2], double rod[2][2], const double f[2], float torque[2]) {
    const double det = rod[0][0] * rod[1][1] - rod[0][1] * rod[1][0];
    const double carried[2] = {(f[0] * rod[1][1] - f[1] * rod[1][0]) / det, (rod[0][0] * f[1] - rod[0][1] * f[0]) / det};
    float most = kMostTorque;
    for (int i = 0; i < 2; ++i) {
        torque[i] = (float)(carried[i] * kInner * (rod[i][1] * cos(angle[i]) - rod[i][0] * sin(angle[i])));
        if (!isfinite(torque[i])) torque[i] = 0; /* stretched out: no force is in their power */
        most = fmaxf(most, fabsf(torque[i]));
    }
    for (int i = 0; i < 2; ++i) torque[i] *= kMostTorque / most; /* together, so that the direction stays */
}

static int32_t exchange(void* opened, const double* force, TactumReading* reading) {
    Pantograph* device = opened;
    double handle[2], rod[2][2];
    float torque[2];
    int fresh = 0;
    ssize_t count;
    while ((count = read(device->port, device->answer + device->got, sizeof device->answer - device->got)) > 0) {
        float degrees[2];
        device->got += (size_t)count;
        if (device->answer[0] != BOARD) device->got = 0; /* the middle of an answer */
        if (device->got < sizeof device->answer) continue;
        memcpy(degrees, device->answer + 1, sizeof degrees);
        device->got = 0;
        if (!isfinite(degrees[0]) || !isfinite(degrees[1])) continue;
        for (int i = 0; i < 2; ++i) device->angle[1 - i] = degrees[i] * (3.14159265358979 / 180);
        fresh = 1;
    }
    device->silent = fresh ? 0 : device->silent + 1;
    kinematics(device->angle, handle, rod);
    if (fresh) { /* the person sits where y points to: right is against x, and toward the person is z */
        const double f[2] = {-force[0], force[2]};
        reading->position[0] = kApart / 2 - handle[0];
        reading->position[2] = handle[1] - kMiddle;
        torques(device->angle, rod, f, torque);
        const float by_port[2] = {torque[1], torque[0]};
        send_to(device->port, TORQUES, by_port, sizeof by_port);
    } else if (device->silent % 20 == 0) {
        stop(device); /* an answer was lost: ask again */
    }
    return fresh ? 1 : device->silent > 100 ? -1 : 0;
}

static void close_port(void* opened) {
    stop(opened);
    tcdrain(((Pantograph*)opened)->port);
    close(((Pantograph*)opened)->port);
    free(opened);
}

const TactumDriver* tactum_driver(uint32_t abi) {
    static const TactumDriver driver = {.size = sizeof(TactumDriver), .find = find, .open = open_port, .exchange = exchange,
                                        .stop = stop, .close = close_port};
    return abi == TACTUM_DRIVER_ABI ? &driver : NULL;
}
