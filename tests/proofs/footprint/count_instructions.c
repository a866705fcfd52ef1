/* A plugin for QEMU that counts instructions between two marks of the program, all of them exactly:
 *   -plugin count_instructions.so,on=ADDRESS,off=ADDRESS,report=ADDRESS,out=FILE
 * Whenever `report` is reached, the sum of all stretches from `on` to `off` becomes a line of the file,
 * and the sum begins anew. */
#include "../counting_plugin.h"

static uint64_t executed, executed_at_on, sum;

static void on(unsigned int cpu, void *data) { executed_at_on = executed; }
static void off(unsigned int cpu, void *data) { sum += executed - executed_at_on; }
static void report(unsigned int cpu, void *data) {
  fprintf(out, "%llu\n", (unsigned long long)sum);
  fflush(out);
  sum = 0;
}

static void translated(uint64_t id, struct qemu_plugin_tb *block) {
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, add_to_counter, &executed, 1);
    watch_marks(instruction);
  }
}
