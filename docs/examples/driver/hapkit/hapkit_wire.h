/* What goes between a Hapkit's board and its driver, for both of them: five bytes each way.
 *
 *   to the board  0xC3, the force in mN (16 bits, low byte first), its complement's low byte, a check
 *   and back      0xA5, the handle's place in 0.01 mm (16 bits, low byte first), the version, a check
 *
 * The check is the sum of the bytes before it. The board answers each command, and switches its motor off when none
 * came for 50 ms. */
#ifndef HAPKIT_WIRE_H
#define HAPKIT_WIRE_H

#include <stdint.h>

#define HAPKIT_BAUD 500000 /* that an ATmega of 16 MHz makes without an error */
#define HAPKIT_SILENCE_MS 50
enum { HAPKIT_COMMAND = 0xC3, HAPKIT_ANSWER = 0xA5, HAPKIT_SIZE = 5, HAPKIT_VERSION = 1 };

typedef struct {
    uint8_t bytes[HAPKIT_SIZE];
    uint8_t count;
} HapkitReader; /* all zero at first */

static inline uint8_t hapkit_sum(const uint8_t* bytes) {
    return (uint8_t)(bytes[0] + bytes[1] + bytes[2] + bytes[3]);
}

static inline uint8_t hapkit_fourth(uint8_t kind, uint8_t low) {
    return kind == HAPKIT_COMMAND ? (uint8_t)~low : (uint8_t)HAPKIT_VERSION;
}

static inline void hapkit_put(uint8_t* packet, uint8_t kind, int16_t value) {
    packet[0] = kind;
    packet[1] = (uint8_t)((uint16_t)value & 0xFF);
    packet[2] = (uint8_t)((uint16_t)value >> 8);
    packet[3] = hapkit_fourth(kind, packet[1]);
    packet[4] = hapkit_sum(packet);
}

/* 1: a packet of this kind is whole, and `value` is what it says. Garbage is passed over. */
static inline int hapkit_take(HapkitReader* reader, uint8_t kind, uint8_t byte, int16_t* value) {
    uint8_t* const b = reader->bytes;
    b[reader->count++] = byte;
    if (reader->count == HAPKIT_SIZE && b[0] == kind && b[3] == hapkit_fourth(kind, b[1]) && b[4] == hapkit_sum(b)) {
        *value = (int16_t)(b[1] | (uint16_t)b[2] << 8);
        reader->count = 0;
        return 1;
    }
    if (b[0] != kind || reader->count == HAPKIT_SIZE) { /* go on at the next byte that may begin one */
        uint8_t from = 1, to = 0;
        while (from < reader->count && b[from] != kind) ++from;
        while (from < reader->count) b[to++] = b[from++];
        reader->count = to;
    }
    return 0;
}

#endif
