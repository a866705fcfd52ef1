// Queues, as in FreeRTOS.
#ifndef DISCMC_RTOS_QUEUE_H
#define DISCMC_RTOS_QUEUE_H

#include "FreeRTOS.h"

using QueueHandle_t = StaticQueue_t*;

QueueHandle_t xQueueCreateStatic(UBaseType_t length, UBaseType_t item_bytes, std::uint8_t* storage,
                                 StaticQueue_t* queue);
BaseType_t xQueueSend(QueueHandle_t queue, const void* item, TickType_t ticks);
BaseType_t xQueueReceive(QueueHandle_t queue, void* item, TickType_t ticks);
BaseType_t xQueueSendFromISR(QueueHandle_t queue, const void* item, BaseType_t* wakes_task);

/// Waits for an item, which no interrupt on a board could: the scanner here is never too fast.
BaseType_t xQueueReceiveFromISR(QueueHandle_t queue, void* item, BaseType_t* wakes_task);

#endif
