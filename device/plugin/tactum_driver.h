// What a driver of your own is to Tactum: a shared library of C functions. docs/drivers.md leads through one.
//
// It is put into ~/.local/share/Tactum/drivers (or a folder that TACTUM_DRIVERS names) and runs in a process
// of its own, which Tactum starts for the device: if it crashes or hangs, the force is zero within 10 ms and
// Tactum goes on. Tactum limits the force, guards stability and keeps time; a driver only reads and pushes.
//
// Frame D of the device: x to the right, y up, z toward the person; metres, newtons, seconds.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Of everything below. A later version only adds at the ends of structs: their sizes tell. */
#define TACTUM_DRIVER_ABI 1
/** Room for a text with its final zero, in bytes of UTF-8. */
#define TACTUM_TEXT 256

/** What the device can do, as its maker says or you have measured. What is 0 is not known, where not said
 * otherwise. */
typedef struct TactumFigures {
    double rate;                /**< Hz, exchanges a second; 150 to 10,000; must be known */
    double max_force;           /**< N; no command is ever larger; must be known */
    double continuous_force;    /**< N, that the motors bear for ever; 0: as much as max_force */
    double max_stiffness;       /**< N/m, the maker's figure */
    double workspace_radius;    /**< m, of the largest sphere about the origin of D; must be known */
    double position_resolution; /**< m */
    double damping;             /**< N s/m, the device's own */
    double dry_friction;        /**< N, the device's own */
    double amplifier_lag;       /**< s, time constant from command to force */
    double delay;               /**< ticks between a reading and the force that answers it */
    int32_t buttons;            /**< on its handle, at most 31 */
    int32_t measures_velocity;  /**< 0: Tactum makes the velocity from the positions */
} TactumFigures;

/** One device that is connected. Tactum gives it to find() full of zeros. */
typedef struct TactumFound {
    char port[TACTUM_TEXT];    /**< tells it from others: "/dev/ttyACM0" */
    char name[TACTUM_TEXT];    /**< for the person: "Haply 2DIY" */
    char trouble[TACTUM_TEXT]; /**< why it cannot be used and what to do, one line; empty: it can */
    TactumFigures figures;
} TactumFound;

/** One reading. Tactum gives it to exchange() full of zeros. */
typedef struct TactumReading {
    double position[3];  /**< m */
    double velocity[3];  /**< m/s, where measures_velocity */
    uint32_t buttons;    /**< a bit for each that is held */
    int64_t measured_at; /**< ns of CLOCK_MONOTONIC; 0: during this exchange */
} TactumReading;

/** What a driver does. What may be NULL says so. Functions are called by one thread at a time. */
typedef struct TactumDriver {
    uint32_t size; /**< sizeof(TactumDriver), as the driver was compiled */
    /** Writes what is connected into `found`, at most `room`, and returns how many. May take a second. */
    int32_t (*find)(TactumFound* found, int32_t room);
    /** Opens a device, homed and without force. May take long. Returns the driver's own pointer, or NULL and
     * why, one line, in `trouble` (TACTUM_TEXT bytes). */
    void* (*open)(const char* port, char* trouble);
    /** Pushes with `force` (three numbers, N, finite and at most max_force) and reads. Called `rate` times a
     * second by a real-time thread: no allocation, no lock, and never waits longer than a tick. Returns 1:
     * the reading is new; 0: nothing new came; -1: the device is gone. */
    int32_t (*exchange)(void* device, const double* force, TactumReading* reading);
    /** Takes all force away at once; from a signal handler too, while exchange() runs. May be NULL. */
    void (*stop)(void* device);
    /** Zero force first; `device` is not used again. */
    void (*close)(void* device);
    /** Why readings do not come and what to do, one line, "" while all is well; also while exchange() runs,
     * by another thread. The text stays valid until close(). May be NULL. */
    const char* (*trouble)(void* device);
} TactumDriver;

/** The one function that Tactum looks for. `abi`: TACTUM_DRIVER_ABI of the Tactum that asks; NULL where the
 * driver cannot serve it. The answer stays valid. */
const TactumDriver* tactum_driver(uint32_t abi);

#ifdef __cplusplus
}
#endif
