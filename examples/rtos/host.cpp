// FreeRTOS and the peripherals of rtos_task.cpp, on a computer: a thread is the task, another one
// the scanner, whose interrupts it calls. The UART is standard output.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <discmc/lattice.hpp>

#include "peripherals.h"
#include "queue.h"
#include "task.h"

namespace {

// Waits for what is to become true; false when the time is over before.
template <class Condition>
bool wait(std::condition_variable& changed, std::unique_lock<std::mutex>& lock, TickType_t ticks,
          Condition condition) {
  if (ticks != portMAX_DELAY)
    return changed.wait_for(lock, std::chrono::milliseconds(ticks), condition);
  changed.wait(lock, condition);
  return true;
}

}  // namespace

// ---- queues ----

QueueHandle_t xQueueCreateStatic(UBaseType_t length, UBaseType_t item_bytes, std::uint8_t* storage,
                                 StaticQueue_t* queue) {
  queue->storage = storage;
  queue->length = length;
  queue->item_bytes = item_bytes;
  queue->first = 0;
  queue->count = 0;
  return queue;
}

BaseType_t xQueueSend(QueueHandle_t queue, const void* item, TickType_t ticks) {
  std::unique_lock<std::mutex> lock(queue->mutex);
  if (!wait(queue->changed, lock, ticks, [queue] { return queue->count < queue->length; }))
    return pdFALSE;
  const UBaseType_t place = (queue->first + queue->count++) % queue->length;
  std::memcpy(queue->storage + place * queue->item_bytes, item, queue->item_bytes);
  queue->changed.notify_all();
  return pdTRUE;
}

BaseType_t xQueueReceive(QueueHandle_t queue, void* item, TickType_t ticks) {
  std::unique_lock<std::mutex> lock(queue->mutex);
  if (!wait(queue->changed, lock, ticks, [queue] { return queue->count > 0; })) return pdFALSE;
  std::memcpy(item, queue->storage + queue->first * queue->item_bytes, queue->item_bytes);
  queue->first = (queue->first + 1) % queue->length;
  --queue->count;
  queue->changed.notify_all();
  return pdTRUE;
}

BaseType_t xQueueSendFromISR(QueueHandle_t queue, const void* item, BaseType_t*) {
  return xQueueSend(queue, item, 0);
}

BaseType_t xQueueReceiveFromISR(QueueHandle_t queue, void* item, BaseType_t*) {
  return xQueueReceive(queue, item, pdMS_TO_TICKS(10000));
}

// ---- the task ----

namespace {

TaskFunction_t function;
void* function_argument;
StaticTask_t* the_task;

}  // namespace

TaskHandle_t xTaskCreateStatic(TaskFunction_t task_function, const char*, std::uint32_t,
                               void* argument, UBaseType_t, StackType_t*, StaticTask_t* task) {
  function = task_function;
  function_argument = argument;
  task->notifications = 0;
  the_task = task;
  return task;
}

void vTaskDelete(TaskHandle_t) {}

void vTaskStartScheduler() {
  the_task->thread = std::thread(function, function_argument);
  the_task->thread.join();
}

void vTaskNotifyGiveFromISR(TaskHandle_t task, BaseType_t*) {
  const std::lock_guard<std::mutex> lock(task->mutex);
  ++task->notifications;
  task->notified.notify_all();
}

std::uint32_t ulTaskNotifyTake(BaseType_t clears, TickType_t ticks) {
  std::unique_lock<std::mutex> lock(the_task->mutex);
  wait(the_task->notified, lock, ticks, [] { return the_task->notifications > 0; });
  const std::uint32_t count = the_task->notifications;
  if (count > 0) the_task->notifications = clears == pdTRUE ? 0 : count - 1;
  return count;
}

// ---- the peripherals ----

namespace {

// A ball, densest in its middle.
std::uint8_t sample_at(std::int32_t x, std::int32_t y, std::int32_t z) {
  constexpr std::int32_t size = sensor_pixels;
  const discmc::Vertex v{2 * x - size + 1, 2 * y - size + 1, 2 * z - size + 1};
  return static_cast<std::uint8_t>(255 - dot_product(v, v) / 26);
}

// A thread that reads one row at a time, and stops with the program.
class Sensor {
 public:
  ~Sensor() {
    ask(nullptr, 0);
    thread_.join();
  }

  void ask(std::uint8_t* samples, std::uint32_t number) {
    const std::lock_guard<std::mutex> lock(mutex_);
    samples_ = samples;
    number_ = number;
    is_asked_ = true;
    asked_.notify_all();
  }

 private:
  void run() {
    while (std::uint8_t* samples = next()) {
      const auto line = static_cast<std::int32_t>(number_);
      constexpr std::int32_t size = sensor_pixels;
      for (std::int32_t x = 0; x < size; ++x) samples[x] = sample_at(x, line % size, line / size);
      on_row_read();
    }
  }

  std::uint8_t* next() {
    std::unique_lock<std::mutex> lock(mutex_);
    asked_.wait(lock, [this] { return is_asked_; });
    is_asked_ = false;
    return samples_;
  }

  std::mutex mutex_;
  std::condition_variable asked_;
  bool is_asked_ = false;
  std::uint8_t* samples_ = nullptr;
  std::uint32_t number_ = 0;
  std::thread thread_{[this] { run(); }};
};

}  // namespace

void read_row(std::uint8_t* samples, std::uint32_t number) {
  static Sensor sensor;
  sensor.ask(samples, number);
}

void send_bytes(const std::uint8_t* bytes, std::size_t count) {
  std::fwrite(bytes, 1, count, stdout);
  on_bytes_sent();
}
