/* What the plugins for QEMU share that count between marks of a program. A plugin has functions
 *   on, off, report   which are called where the program reaches its marks
 *   translated      which is called for every block of instructions, and calls watch_marks()
 * and is loaded with -plugin FILE.so,on=ADDRESS,off=ADDRESS,report=ADDRESS,out=FILE. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* QEMU's plugin interface, as far as versions 1 and 3 agree; its header is not always packaged. */
#define EXPORT __attribute__((visibility("default")))
struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef void (*translated_cb)(uint64_t id, struct qemu_plugin_tb *block);
typedef void (*executed_cb)(unsigned int cpu, void *data);
enum { uses_no_registers = 0 };
void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id, translated_cb callback);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *instruction);
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *block, executed_cb callback,
                                          int flags, void *data);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *instruction,
                                            executed_cb callback, int flags, void *data);
/* QEMU refuses plugins of older or newer versions than it supports. Version 3, that of QEMU 9, is the
 * first with scoreboards. */
EXPORT int qemu_plugin_version;
__attribute__((weak)) void *qemu_plugin_scoreboard_new(size_t bytes);
__attribute__((constructor)) static void choose_version(void) {
  qemu_plugin_version = qemu_plugin_scoreboard_new ? 3 : 1;
}

static void on(unsigned int cpu, void *data);
static void off(unsigned int cpu, void *data);
static void report(unsigned int cpu, void *data);
static void translated(uint64_t id, struct qemu_plugin_tb *block);

static FILE *out;

static struct {
  const char *name;
  executed_cb reached;
  uint64_t address;
} marks[] = {{"on=", on, 0}, {"off=", off, 0}, {"report=", report, 0}};
enum { mark_count = sizeof marks / sizeof marks[0] };

/* data: for the function of a mark at this instruction. */
static void watch_marks(struct qemu_plugin_insn *instruction, void *data) {
  for (int m = 0; m < mark_count; ++m)
    if (qemu_plugin_insn_vaddr(instruction) == marks[m].address)
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, marks[m].reached, uses_no_registers, data);
}

EXPORT int qemu_plugin_install(uint64_t id, const void *info, int count, char **arguments) {
  for (int i = 0; i < count; ++i) {
    if (strncmp(arguments[i], "out=", 4) == 0) out = fopen(arguments[i] + 4, "w");
    for (int m = 0; m < mark_count; ++m)
      if (strncmp(arguments[i], marks[m].name, strlen(marks[m].name)) == 0)
        marks[m].address = strtoull(strchr(arguments[i], '=') + 1, 0, 0);
  }
  if (!out) return 1;
  qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
  return 0;
}
