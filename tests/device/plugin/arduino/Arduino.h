// As much of the Arduino core as hapkit.ino needs, for a board that is none (fake_hapkit.cpp). What each of
// them does is in Arduino's language reference.
#pragma once

#include <cstddef>
#include <cstdint>

inline constexpr std::uint8_t A2 = 16, LOW = 0, HIGH = 1, INPUT = 0, OUTPUT = 1;
extern std::uint8_t TCCR0B; ///< how fast timer 0 counts, which millis() and the motor's pulses go by

void pinMode(std::uint8_t pin, std::uint8_t mode);
void digitalWrite(std::uint8_t pin, std::uint8_t level);
void analogWrite(std::uint8_t pin, int duty);
int analogRead(std::uint8_t pin);
std::uint32_t millis();

struct ArduinoSerial {
    void begin(long baud);
    int available();
    int read();
    std::size_t write(const std::uint8_t* bytes, std::size_t count);
};
extern ArduinoSerial Serial;

// Of the sketch.
void setup();
void loop();
