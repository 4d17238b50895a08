/* Drivers as they should not be, one by each macro. */
#include <string.h>

#include "tactum_driver.h"

static int32_t find(TactumFound* found, int32_t room) {
    (void)room;
    memset(found[0].port, 'p', TACTUM_TEXT); /* no end */
    memset(found[0].name, '\n', 3);
    found[0].figures.rate = 1000;
    found[0].figures.workspace_radius = 0.1;
#ifdef WITHOUT_FORCE
    found[0].figures.max_force = -1;
#else
    found[0].figures.max_force = 2;
#endif
#ifdef COUNTS_WRONG
    return 1000000;
#else
    return 1;
#endif
}

static void* open_device(const char* port, char* trouble) {
    (void)port;
    memset(trouble, 't', TACTUM_TEXT);
    return 0;
}

int32_t exchange(void* device, const double* force, TactumReading* reading) {
    (void)device, (void)force, (void)reading;
    return 0;
}

static void close_device(void* device) {
    (void)device;
}

#ifdef LACKS_EXCHANGE
#define EXCHANGE 0
#else
#define EXCHANGE exchange
#endif

const TactumDriver kDriver = {.size = sizeof(TactumDriver), .find = find, .open = open_device, .exchange = EXCHANGE,
                              .close = close_device};

#ifndef WITHOUT_ENTRY
const TactumDriver* tactum_driver(uint32_t abi) {
#ifdef OTHER_VERSION
    abi -= 1;
#endif
    return abi == TACTUM_DRIVER_ABI ? &kDriver : 0;
}
#endif
