/* What a Hapkit 3.0 runs so that Tactum can drive it (../hapkit.c, docs/drivers.md). Never tried with a real one.
 *
 * Hold the handle upright while the board starts: that is its middle. Then calibrate two figures: kLow and kHigh are
 * the least and the most that analogRead() gives while the handle goes from end to end.
 *
 * Pins, and a motor whose torque grows with the square of its duty: Stanford's Hapkit sketch, "Code to test basic
 * Hapkit functionality" by T. Morimoto and A. Okamura. Radii and the sensor's ends: those that
 * github.com/reitermarkus/hapkit measured of its own one. */
#include <math.h>

#include "hapkit_wire.h"

static const uint8_t kMotor = 5, kWay = 8, kSensor = A2;
static const int kLow = 48, kHigh = 971;                                       /* of the sensor, over half a turn */
static const float kHandle = 0.065659F, kPulley = 0.004191F, kSector = 0.073152F; /* m, radii */
static const float kMostTorque = 0.03F;                                         /* N m, of the motor, at full duty */
/* 62.5 kHz for the motor, which nobody hears, makes the clock of millis() run 64 times as fast. */
static const uint32_t kSilence = 64UL * HAPKIT_SILENCE_MS;

static HapkitReader reader;
static int last, turns, middle;
static uint32_t heard;

/* The sensor begins anew each half turn of the pulley. */
static int counts() {
    const int now = analogRead(kSensor), range = kHigh - kLow;
    if (now - last > range / 2) --turns;
    if (last - now > range / 2) ++turns;
    last = now;
    return now + turns * range;
}

static float place() {
    const float half = (float)(counts() - middle) / (float)(kHigh - kLow);
    return kHandle * kPulley / kSector * (float)M_PI * half;
}

static void push(float force) {
    const float torque = force * kHandle * kPulley / kSector;
    const float duty = sqrtf(fabsf(torque) / kMostTorque);
    digitalWrite(kWay, force > 0 ? HIGH : LOW);
    analogWrite(kMotor, duty >= 1 ? 255 : (int)(255 * duty));
}

void setup() {
    TCCR0B = (TCCR0B & 0xF8) | 1;
    pinMode(kMotor, OUTPUT);
    pinMode(kWay, OUTPUT);
    pinMode(kSensor, INPUT);
    push(0);
    Serial.begin(HAPKIT_BAUD);
    last = analogRead(kSensor);
    middle = counts();
}

void loop() {
    const float where = place(); /* at every turn of the loop, so that no half turn is missed */
    int16_t force;
    while (Serial.available() > 0) {
        uint8_t answer[HAPKIT_SIZE];
        if (!hapkit_take(&reader, HAPKIT_COMMAND, (uint8_t)Serial.read(), &force)) continue;
        heard = millis();
        push(0.001F * force);
        hapkit_put(answer, HAPKIT_ANSWER, (int16_t)lroundf(1e5F * where));
        Serial.write(answer, HAPKIT_SIZE);
    }
    if (millis() - heard > kSilence) push(0);
}
