/* A plugin for QEMU that counts how often each block of instructions runs between two marks of the
 * program, and how often it is left by a branch that is taken:
 *   -plugin count_blocks.so,on=ADDRESS,off=ADDRESS,tell=ADDRESS,out=FILE
 * Whenever `tell` is reached, a line goes to the file for each block that ran in the stretches from
 * `on` to `off`: its first address, how many instructions it has, how often it ran, and how often it
 * was left for elsewhere than the one behind. The word `end` ends them, and the counts begin anew. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Version 1 of QEMU's plugin interface, as far as it is used; its header is not always packaged. */
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
EXPORT int qemu_plugin_version = 1;

struct block {
  uint64_t begin, end, instructions, runs, taken;
  struct block *next;
};
static struct block *blocks, *last;
static int counts;
static FILE *out;

static void run(unsigned int cpu, void *data) {
  struct block *block = data;
  if (!counts) return;
  ++block->runs;
  if (last && last->end != block->begin) ++last->taken;
  last = block;
}

static void on(unsigned int cpu, void *data) {
  counts = 1;
  last = 0;
}
static void off(unsigned int cpu, void *data) { counts = 0; }
static void tell(unsigned int cpu, void *data) {
  for (struct block *block = blocks; block; block = block->next) {
    if (block->runs)
      fprintf(out, "%llx %llu %llu %llu\n", (unsigned long long)block->begin,
              (unsigned long long)block->instructions, (unsigned long long)block->runs,
              (unsigned long long)block->taken);
    block->runs = block->taken = 0;
  }
  fprintf(out, "end\n");
  fflush(out);
}

static struct {
  const char *name;
  executed_cb reached;
  uint64_t address;
} marks[] = {{"on=", on, 0}, {"off=", off, 0}, {"tell=", tell, 0}};
enum { mark_count = sizeof marks / sizeof marks[0] };

static void translated(uint64_t id, struct qemu_plugin_tb *translation) {
  size_t count = qemu_plugin_tb_n_insns(translation);
  struct qemu_plugin_insn *end = qemu_plugin_tb_get_insn(translation, count - 1);
  struct block *block = calloc(1, sizeof *block);
  if (!block) abort();
  block->begin = qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(translation, 0));
  block->end = qemu_plugin_insn_vaddr(end) + qemu_plugin_insn_size(end);
  block->instructions = count;
  block->next = blocks;
  blocks = block;
  qemu_plugin_register_vcpu_tb_exec_cb(translation, run, uses_no_registers, block);
  for (size_t i = 0; i < count; ++i) {
    struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(translation, i);
    for (int m = 0; m < mark_count; ++m)
      if (qemu_plugin_insn_vaddr(instruction) == marks[m].address)
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, marks[m].reached, uses_no_registers, 0);
  }
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
