// examples/firmware.c on a board: its main(), its standard output, and no source of rows.
#include <board.hpp>
#include <port.hpp>

extern "C" {
int firmware_main();
size_t fwrite(const void* bytes, size_t size, size_t count, void* file);
}

size_t fwrite(const void* bytes, size_t size, size_t count, void*) {
  return board::uart_write(nullptr, static_cast<const uint8_t*>(bytes), size * count) / size;
}

void source::start() {}
void source::on_request() {}
void source::on_interrupt() {}

int main() {
  board::start();
  board::stop(firmware_main() == 0);
}
