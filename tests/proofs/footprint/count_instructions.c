/* A plugin for QEMU that counts instructions between two marks of the program, all of them exactly:
 *   -plugin count_instructions.so,on=ADDRESS,off=ADDRESS,report=ADDRESS,out=FILE
 * Whenever `report` is reached, the sum of all stretches from `on` to `off` becomes a line of the file,
 * and the sum begins anew. */
#include "../counting_plugin.h"

/* A block is counted where it begins. data: the number of its instructions from there to its end. */
static uint64_t executed, executed_at_on, sum;

static uint64_t executed_before(const void *data) { return executed - (uintptr_t)data; }
static void on(unsigned int cpu, void *data) { executed_at_on = executed_before(data); }
static void off(unsigned int cpu, void *data) { sum += executed_before(data) - executed_at_on; }
static void report(unsigned int cpu, void *data) {
  fprintf(out, "%llu\n", (unsigned long long)sum);
  fflush(out);
  sum = 0;
}

static void run(unsigned int cpu, void *data) { executed += (uintptr_t)data; }

static void translated(uint64_t id, struct qemu_plugin_tb *block) {
  uintptr_t ahead = qemu_plugin_tb_n_insns(block);
  qemu_plugin_register_vcpu_tb_exec_cb(block, run, uses_no_registers, (void *)ahead);
  for (size_t i = 0; ahead > 0; ++i, --ahead)
    watch_marks(qemu_plugin_tb_get_insn(block, i), (void *)ahead);
}
