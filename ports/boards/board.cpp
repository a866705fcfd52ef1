// The board's interface to the application, composed of the parts of a port.
#include "board.hpp"

#include "memory_image.hpp"
#include "port.hpp"
#include "semihosting.hpp"

void board::start() {
  uart::start();
  source::start();
}

size_t board::uart_write(void*, const uint8_t* bytes, size_t count) {
  size_t sent = 0;
  while (sent < count && uart::send(bytes[sent])) ++sent;
  return sent;
}

void board::report(const char* name, uint32_t value) {
  char digits[12];
  char* text = digits + sizeof digits;
  *--text = '\0';
  *--text = '\n';
  do *--text = static_cast<char>('0' + value % 10);
  while ((value /= 10) > 0);
  semihosting::print(name);
  semihosting::print(" ");
  semihosting::print(text);
}

void board::fault() {
  semihosting::print("fault\n");
  semihosting::exit(2);
}

void board::stop(bool succeeded) {
  while (!uart::is_idle()) {
  }
  report("stack_used", static_cast<uint32_t>(memory_image::stack_used()));
  report("stack_bytes", static_cast<uint32_t>(memory_image::stack_bytes()));
  semihosting::exit(succeeded ? 0 : 1);
}
