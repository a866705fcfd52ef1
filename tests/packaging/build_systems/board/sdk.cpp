// The parts of a vendor's SDK: a UART that waits for room, and standard output on it. The program
// ends with main(), which the linker wraps (--wrap=main).
#include "sdk.h"

#include <board.hpp>
#include <port.hpp>

extern "C" {
int __real_main();
int __wrap_main();
size_t fwrite(const void* bytes, size_t size, size_t count, void* file);
int fputs(const char* text, void* file);
}

void sdk_write(const uint8_t* bytes, size_t count) {
  while (count > 0) {
    const size_t sent = board::uart_write(nullptr, bytes, count);
    bytes += sent;
    count -= sent;
  }
}

size_t fwrite(const void* bytes, size_t size, size_t count, void*) {
  return board::uart_write(nullptr, static_cast<const uint8_t*>(bytes), size * count) / size;
}

int fputs(const char*, void*) {
  return 0;
}

void source::start() {}
void source::on_request() {}
void source::on_interrupt() {}

int __wrap_main() {
  board::start();
  board::stop(__real_main() == 0);
}
