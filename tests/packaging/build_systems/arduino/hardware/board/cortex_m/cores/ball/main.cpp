// Ends after one loop(); the LED shows the result.
#include <sdk.h>

#include "Arduino.h"

SerialPort Serial;

static bool led_is_on = false;

void SerialPort::begin(unsigned long) {}
size_t SerialPort::write(const uint8_t* bytes, size_t count) {
  sdk_write(bytes, count);
  return count;
}

void pinMode(int, int) {}
void digitalWrite(int, int value) {
  led_is_on = value != LOW;
}

int main() {
  setup();
  loop();
  return led_is_on ? 0 : 1;
}
