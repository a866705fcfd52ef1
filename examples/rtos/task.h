// Tasks, as in FreeRTOS.
#ifndef DISCMC_RTOS_TASK_H
#define DISCMC_RTOS_TASK_H

#include "FreeRTOS.h"

using TaskHandle_t = StaticTask_t*;
using TaskFunction_t = void (*)(void*);

TaskHandle_t xTaskCreateStatic(TaskFunction_t function, const char* name, std::uint32_t stack_words,
                               void* argument, UBaseType_t priority, StackType_t* stack,
                               StaticTask_t* task);

/// Call it in the task itself only, as its last act.
void vTaskDelete(TaskHandle_t task);

/// Runs the task; returns when it has deleted itself, which FreeRTOS never does. Limit: one task.
void vTaskStartScheduler();

void vTaskNotifyGiveFromISR(TaskHandle_t task, BaseType_t* wakes_task);
std::uint32_t ulTaskNotifyTake(BaseType_t clears, TickType_t ticks);

#endif
