// A scanner's firmware under FreeRTOS: an interrupt queues rows, and a task makes the surface and
// sends it.
//
// All memory is static. rtos/ lets this run on a computer; on your board your FreeRTOS replaces it,
// and your drivers replace peripherals.h.
#include <FreeRTOS.h>
#include <peripherals.h>
#include <queue.h>
#include <task.h>

#include <discmc/discmc.hpp>

using namespace discmc;
constexpr uint32_t size = sensor_pixels;  // voxels per row, rows per slice, slices
constexpr uint32_t row_count = size * size;
constexpr int32_t threshold = 192;
constexpr Limits limits{size, size};

struct Row {
  uint32_t number;  // over all slices
  uint8_t samples[size];
};

// Rows circulate: from the free ones to the interrupt, by the full ones to the task, and back.
// There are as many as the scanner delivers while the UART is at its busiest.
constexpr UBaseType_t rows_at_once = 8;
static Row rows[rows_at_once];
static QueueHandle_t free_rows, full_rows;

static TaskHandle_t scanner;
static bool succeeded = false;

// ---- interrupts ----

static Row* filling;
static uint32_t next_number = 0;

// The row is complete. If no other row is free, the scanner overwrites this one, and its number is
// missing in the task.
extern "C" void on_row_read() {
  BaseType_t wakes_task = pdFALSE;
  filling->number = next_number++;
  Row* free = nullptr;
  if (xQueueReceiveFromISR(free_rows, &free, &wakes_task) == pdTRUE) {
    xQueueSendFromISR(full_rows, &filling, &wakes_task);
    filling = free;
  }
  if (next_number < row_count) read_row(filling->samples, next_number);
  portYIELD_FROM_ISR(wakes_task);
}

extern "C" void on_bytes_sent() {
  BaseType_t wakes_task = pdFALSE;
  vTaskNotifyGiveFromISR(scanner, &wakes_task);
  portYIELD_FROM_ISR(wakes_task);
}

// ---- the task ----

static uint8_t arena[Extractor16::minimum_bytes(limits) + 5 * 1024];
static Extractor16 extractor;
static Encoder encoder;

// A task may sleep here. So the output is never busy, and no call is suspended; rows queue up.
static size_t uart_write(void*, const uint8_t* bytes, size_t count) {
  send_bytes(bytes, count);
  ulTaskNotifyTake(pdTRUE, portMAX_DELAY);
  return count;
}

static bool scan_row(const Row& row, uint32_t& next) {
  for (; next < row.number; ++next)
    if (extractor.skip_row(Substitute::previous_row).status != Status::ok) return false;
  ++next;
  return extractor.push(row.samples, size).status == Status::ok;
}

// Without a row for a second the scan ends early, and the rows so far become a closed surface.
static bool scan() {
  if (encoder.start({size}, {nullptr, uart_write}) != Status::ok ||
      extractor.start(limits, threshold, memory_of(arena), make_sink(encoder)) != Status::ok)
    return false;
  read_row(filling->samples, next_number);
  uint32_t next = 0;
  Row* row = nullptr;
  while (next < row_count && xQueueReceive(full_rows, &row, pdMS_TO_TICKS(1000)) == pdTRUE) {
    if (!scan_row(*row, next)) return false;
    xQueueSend(free_rows, &row, 0);
  }
  const bool is_whole = next == row_count;
  return (is_whole ? extractor.finish() : extractor.abandon()) == Status::ok && is_whole;
}

static void run_scanner(void*) {
  succeeded = scan();
  vTaskDelete(nullptr);
}

int main() {
  static StaticQueue_t free_queue, full_queue;
  static uint8_t free_storage[rows_at_once * sizeof(Row*)],
      full_storage[rows_at_once * sizeof(Row*)];
  free_rows = xQueueCreateStatic(rows_at_once, sizeof(Row*), free_storage, &free_queue);
  full_rows = xQueueCreateStatic(rows_at_once, sizeof(Row*), full_storage, &full_queue);
  filling = &rows[0];
  for (UBaseType_t i = 1; i < rows_at_once; ++i) {
    Row* row = &rows[i];
    xQueueSend(free_rows, &row, 0);
  }

  static StaticTask_t task;
  static StackType_t stack[512];
  scanner = xTaskCreateStatic(run_scanner, "scanner", 512, nullptr, 1, stack, &task);
  vTaskStartScheduler();
  return succeeded ? 0 : 1;  // never reached on a board
}
