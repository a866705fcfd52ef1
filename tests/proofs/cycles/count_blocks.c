/* A plugin for QEMU that counts how often each block of instructions runs between two marks of the
 * program. It also counts how often the block is left by a branch that is taken.
 *   -plugin count_blocks.so,on=ADDRESS,off=ADDRESS,report=ADDRESS,out=FILE
 * Whenever `report` is reached, the file gets a line for each block that ran in the stretches from
 * `on` to `off`. Its fields: first address, number of instructions, how often the block ran, and how
 * often another block than the one behind came next. The word `end` ends them, and the counts begin
 * anew. */
#include "../counting_plugin.h"

struct block {
  uint64_t begin, end, instructions, runs, taken;
  struct block *next;
};
static struct block *blocks, *last;
static int counts;

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
static void report(unsigned int cpu, void *data) {
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
  for (size_t i = 0; i < count; ++i) watch_marks(qemu_plugin_tb_get_insn(translation, i), 0);
}
