// The part of Arduino's core that a sketch uses here. It has the macros of Arduino's cores for AVR and
// SAM, with which a library's headers must compile.
#pragma once

#include <stddef.h>
#include <stdint.h>

#define HIGH 0x1
#define LOW 0x0
#define INPUT 0x0
#define OUTPUT 0x1
#define DEFAULT 1
#define EXTERNAL 0
#define CHANGE 1
#define PI 3.1415926535897932384626433832795
#define B0 0
#define B1 1
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define constrain(x, low, high) ((x) < (low) ? (low) : ((x) > (high) ? (high) : (x)))
#define sq(x) ((x) * (x))
#define radians(degrees) ((degrees)*0.017453292519943295769236907684886)
#define degrees(radians) ((radians)*57.295779513082320876798154814105)
#define bit(b) (1UL << (b))
#define word(...) ((uint16_t)(__VA_ARGS__))
#define lowByte(w) ((uint8_t)((w)&0xff))
#define highByte(w) ((uint8_t)((w) >> 8))
#define interrupts() (void)0
#define noInterrupts() (void)0
#define F(text) (text)

typedef uint8_t byte;
typedef bool boolean;

constexpr int LED_BUILTIN = 13;

void pinMode(int pin, int mode);
void digitalWrite(int pin, int value);

struct SerialPort {
  void begin(unsigned long baud);
  size_t write(const uint8_t* bytes, size_t count);
  explicit operator bool() const { return true; }
};
extern SerialPort Serial;

void setup();
void loop();
