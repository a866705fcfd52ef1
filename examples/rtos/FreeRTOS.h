// The part of FreeRTOS that rtos_task.cpp uses, for a computer: types and constants. The functions
// are in queue.h and task.h, and work as in FreeRTOS's manual, with threads (host.cpp).
#ifndef DISCMC_RTOS_FREERTOS_H
#define DISCMC_RTOS_FREERTOS_H

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

using BaseType_t = long;
using UBaseType_t = unsigned long;
using TickType_t = std::uint32_t;
using StackType_t = std::uintptr_t;

constexpr BaseType_t pdFALSE = 0, pdTRUE = 1;
constexpr TickType_t portMAX_DELAY = 0xFFFFFFFF;  // for ever

// A tick is a millisecond.
constexpr TickType_t pdMS_TO_TICKS(TickType_t milliseconds) {
  return milliseconds;
}

// Threads are switched as they like.
constexpr void portYIELD_FROM_ISR(BaseType_t) {}

struct StaticQueue_t {
  std::mutex mutex;
  std::condition_variable changed;
  std::uint8_t* storage;
  UBaseType_t length, item_bytes, first, count;
};

struct StaticTask_t {
  std::mutex mutex;
  std::condition_variable notified;
  std::uint32_t notifications;
  std::thread thread;
};

#endif
