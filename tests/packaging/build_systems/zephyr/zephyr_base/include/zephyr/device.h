/* As much of Zephyr's device.h as the sample uses: one device, the console. */
#pragma once

struct device {
  const char* name;
};

#ifdef __cplusplus
extern "C" {
#endif
extern const struct device zephyr_console;
#ifdef __cplusplus
}
#endif

#define DT_CHOSEN(name) name
#define DEVICE_DT_GET(node) (&node)
